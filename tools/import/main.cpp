// skyway-import: city tables, block texts, simulated worlds, voxels and octrees become box maps.

#include <filesystem>

#include "cli/file/files.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/output_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/import/draft_boxes.h"
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
  std::string frame;
  std::string units = "m";
  std::string unknown = "free";
  bool collisions_only = false;
  geom::BoxDraftOptions draft;

  void settle();  // once parsed
};

// Adds what the options say of SDF worlds and OctoMaps.
void add_format_options(CLI::App& app, Options& options) {
  app.add_option("--unknown", options.unknown,
                 "cells of an OctoMap or a jps3d map that were never seen: free (default) or "
                 "blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  app.add_option("--model-path", options.draft.model_path,
                 "folder that the model:// of an SDF world is looked for in; again for more");
  app.add_option(
         "--slack", options.draft.slack,
         "how far boxes may reach outside meshes, and turned and round bodies, of an SDF world, "
         "metres (default 0.1)")
      ->check(CLI::Range(0.001, 100.0));
  app.add_flag("--collisions-only", options.collisions_only,
               "leave out what an SDF world shows and nothing collides with in the simulator");
  app.add_option("--without", options.draft.without,
                 "name of a model that an SDF world holds and the map shall not, such as the drone "
                 "itself; again for more");
}

void Options::settle() {
  if (!frame.empty()) draft.axes = *geom::value_of(geom::kAxesWords, frame);
  draft.unit = cli::kMetres.at(units);
  draft.unknown_blocked = unknown == "blocked";
  draft.visuals = !collisions_only;
  draft.open = cli::open_input;
#ifdef SKYWAY_MESH
  draft.read_collada = [](const geom::SdfFile& file) {
    return geom::read_collada(file.text, file.name);
  };
#endif
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a city table, block text, Gazebo world, voxels or an OctoMap to a box map.",
               "skyway-import"};
  cli::Common common(app, true);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input,
                 "FCND CSV, box CSV, block text, RotorPy JSON, Gazebo SDF, Moving AI .3dmap, jps3d "
                 "YAML or OctoMap .bt; - for stdin")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::box_formats(), options.draft.format);
  app.add_option("--frame", options.frame, "enu or neu (default: neu for FCND tables, else enu)")
      ->check(CLI::IsMember({"enu", "neu"}));
  app.add_option("--units", options.units, "unit of the source's numbers (default m)")
      ->check(CLI::IsMember(cli::kMetres));
  add_format_options(app, options);
  cli::add_allow_skipped(app, options.draft.allow_skipped);
  cli::add_map_options(app, options.draft.map, "1 for FCND tables, else 0");
  return cli::run_tool(app, argc, argv, [&] {
    cli::InputFile file(input);
    geom::HashedStream hashed(file.stream());
    if (!options.draft.format) {
      options.draft.format = &geom::box_format_of(hashed.head(), file.name());
    }
    const std::string_view word = options.draft.format->format->word;
    cli::require_used(app, format_options(), word, cli::read_as(file.name(), word));
    options.settle();
    if (std::filesystem::is_regular_file(input)) {
      options.draft.bytes = std::filesystem::file_size(input);
    }
    cli::write_map(common, output,
                   geom::draft_boxes(hashed, file.name(), options.draft,
                                     cli::notes_of(common, "skyway-import"),
                                     {common.execution("").threads, {}}));
    return cli::Exit::yes;
  });
}
