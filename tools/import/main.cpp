// skyway-import: city tables, block texts, simulated worlds, voxels and octrees become box maps.

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/import/import_boxes.h"
#include "geom/map/make_map.h"
#include "geom/text/counted.h"
#include "model_files.h"
#ifdef SKYWAY_MESH
#include "geom/model/assimp_scene.h"
#endif

namespace {

std::vector<cli::FormatOption> format_options() {
  std::vector<std::string_view> with_unknown;
  for (const geom::BoxFormat* format : geom::box_formats()) {
    if (format->has_unknown) with_unknown.push_back(format->format->word);
  }
  const std::vector<std::string_view> worlds = {geom::kGazeboWorld.format->word};
  return {{"--unknown", with_unknown},
          {"--model-path", worlds},
          {"--slack", worlds},
          {"--collisions-only", worlds},
          {"--without", worlds}};
}

struct Options {
  const geom::BoxFormat* format = nullptr;  // null: found out
  std::string frame;
  std::string units = "m";
  std::string unknown = "free";
  cli::SkippedOption skipped;
  cli::MapOptions map;
  geom::SdfOptions sdf;
  bool collisions_only = false;
  std::vector<std::string> without;
  std::vector<std::string> model_path;
};

// Of what was imported, the map that the options ask for.
geom::MakeMapOptions map_options(const Options& options, const geom::ImportedBoxes& boxes) {
  geom::MakeMapOptions map = options.map.make(boxes.seal);
  map.scale *= cli::kMetres.at(options.units);
  map.source_bounds = boxes.bounds;
  if (!map.floor) map.floor = boxes.floor;
  return map;
}

void warn(const geom::ImportedBoxes& boxes, bool unknown_blocked, const std::string& file,
          const cli::Common& common) {
  for (const std::string& key : boxes.names)
    common.warn(file + ": an unknown key is ignored: " + key);
  if (boxes.unknown > 0 && !unknown_blocked) {
    common.warn(
        fmt::format("{}: {} within the bounds never seen; this counts as free (--unknown blocked "
                    "makes it obstacles)",
                    file, geom::counted(boxes.unknown, "cell was", "cells were")));
  }
  if (boxes.reversed > 0) {
    common.warn(fmt::format("{}: {} the upper corner first; taken as the box between both corners",
                            file, geom::counted(boxes.reversed, "box has", "boxes have")));
  }
  if (boxes.flat > 0)
    cli::tell(common, "skyway-import",
              fmt::format("{}: {} kept", file,
                          geom::counted(boxes.flat, "flat box is", "flat boxes are")));
  if (boxes.movable > 0)
    cli::tell(common, "skyway-import",
              fmt::format("{}: {} not static, and taken where the file puts {}", file,
                          geom::counted(boxes.movable, "model is", "models are"),
                          boxes.movable == 1 ? "it" : "them"));
}

nlohmann::ordered_json step_of(const std::string& hash, const Options& options,
                               const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {
      {"tool", "skyway-import"}, {"input", hash}, {"format", options.format->format->word}};
  step.update(cli::history_of(map));
  if (options.format->has_unknown) step["unknown"] = options.unknown;
  if (options.format == &geom::kGazeboWorld) {
    step["slack"] = options.sdf.slack;
    if (options.collisions_only) step["collisions_only"] = true;
    if (!options.without.empty()) step["without"] = options.without;
  }
  return step;
}

// Adds what the options say of SDF worlds and OctoMaps.
void add_format_options(CLI::App& app, Options& options) {
  app.add_option("--unknown", options.unknown,
                 "cells of an OctoMap or a jps3d map that were never seen: free (default) or "
                 "blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  app.add_option("--model-path", options.model_path,
                 "folder that the model:// of an SDF world is looked for in; again for more");
  app.add_option(
         "--slack", options.sdf.slack,
         "how far boxes may reach outside meshes, and turned and round bodies, of an SDF world, "
         "metres (default 0.1)")
      ->check(CLI::Range(0.001, 100.0));
  app.add_flag("--collisions-only", options.collisions_only,
               "leave out what an SDF world shows and nothing collides with in the simulator");
  app.add_option("--without", options.without,
                 "name of a model that an SDF world holds and the map shall not, such as the drone "
                 "itself; again for more");
}

geom::ImportedBoxes imported(Options& options, std::istream& in, const std::string& name,
                             import::ModelFiles& models) {
  options.sdf.visuals = !options.collisions_only;
  options.sdf.without = {options.without.begin(), options.without.end()};
  options.sdf.open = [&](const std::string& uri, const std::string& from) {
    return models.open(uri, from);
  };
  options.sdf.open_mesh = [&](const std::string& uri, const std::string& from) {
    return models.open_mesh(uri, from);
  };
#ifdef SKYWAY_MESH
  options.sdf.read_collada = [](const geom::SdfFile& file) {
    return geom::read_collada(file.text, file.name);
  };
#endif
  geom::ImportedBoxes boxes =
      options.format->read(in, name, {options.unknown == "blocked", options.sdf});
  for (const std::string& model : options.without) {
    if (!boxes.left_out.contains(model))
      throw geom::InputError(name, {.expected = "a model of the name that --without gives",
                                    .found = fmt::format("none: \"{}\"", model)});
  }
  return boxes;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a city table, block text, Gazebo world, voxels or an OctoMap to a box map.",
               "skyway-import"};
  cli::Common common(app);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input,
                 "FCND CSV, box CSV, block text, RotorPy JSON, Gazebo SDF, Moving AI .3dmap, jps3d "
                 "YAML or OctoMap .bt; - for stdin")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::box_formats(), options.format);
  app.add_option("--frame", options.frame, "enu or neu (default: neu for FCND tables, else enu)")
      ->check(CLI::IsMember({"enu", "neu"}));
  app.add_option("--units", options.units, "unit of the source's numbers (default m)")
      ->check(CLI::IsMember(cli::kMetres));
  add_format_options(app, options);
  options.skipped.add_to(app);
  options.map.add_to(app, "1 for FCND tables, else 0");
  return cli::run_tool(app, argc, argv, [&] {
    cli::InputFile file(input);
    cli::HashedInput hashed(file);
    if (!options.format) options.format = &geom::box_format_of(hashed.head(), file.name());
    const std::string_view word = options.format->format->word;
    cli::require_used(app, format_options(), word, cli::read_as(file.name(), word));
    import::ModelFiles models(options.model_path);
    geom::ImportedBoxes boxes = imported(options, hashed.stream(), file.name(), models);
    if (!options.frame.empty()) boxes.frame.axes = *geom::value_of(geom::kAxesWords, options.frame);
    warn(boxes, options.unknown == "blocked", file.name(), common);
    cli::only_for(
        app, !boxes.bounds, {"--pad"},
        "files without bounds of their own (--floor, --ceiling and --bounds change them)");
    const geom::MakeMapOptions map = map_options(options, boxes);
    nlohmann::ordered_json step = step_of(hashed.hash(), options, map);
    if (!models.hashes().empty()) step["includes"] = models.hashes();
    options.skipped.settle(boxes.skipped, file.name(), common, step);
    if (boxes.table.boxes.empty())
      throw geom::InputError(file.name(), {.expected = "at least one obstacle", .found = "none"});
    const geom::MadeMap made =
        geom::make_map(std::move(boxes.table), boxes.frame,
                       nlohmann::ordered_json::array({step}).dump(), file.name(), map);
    nlohmann::ordered_json stats = {
        {"format", word}, {"flat", boxes.flat}, {"largest_change_m", boxes.largest_change}};
    if (!boxes.skipped.empty()) stats["skipped"] = boxes.skipped.count();
    if (options.format == &geom::kGazeboWorld) stats["movable"] = boxes.movable;
    cli::write_map(common, output, made, file.name(), stats);
    return cli::Exit::yes;
  });
}
