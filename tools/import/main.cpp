// skyway-import: city tables, block texts, voxels and octrees become box maps.

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "cli/file/map_output.h"
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

namespace {

struct Options {
  std::string format = "auto";
  std::string frame;
  std::string units = "m";
  std::string unknown = "free";
  cli::SkippedOption skipped;
  cli::MapOptions map;
};

std::vector<std::string> formats() {
  std::vector<std::string> out = {"auto"};
  for (const auto& [format, word] : geom::kBoxFormatWords) out.emplace_back(word);
  return out;
}

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
  if (boxes.flat > 0)
    cli::tell(common, "skyway-import",
              fmt::format("{}: {} kept", file,
                          geom::counted(boxes.flat, "flat box is", "flat boxes are")));
}

nlohmann::ordered_json step_of(const std::string& hash, const Options& options,
                               const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {
      {"tool", "skyway-import"}, {"input", hash}, {"format", options.format}};
  step.update(cli::history_of(map));
  if (options.format == "octomap") step["unknown"] = options.unknown;
  return step;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a city table, block text, voxels or an OctoMap to a box map.",
               "skyway-import"};
  cli::Common common(app);
  Options options;
  std::string input;
  std::string output = "-";
  app.add_option("file", input,
                 "FCND CSV, box CSV, block text, RotorPy JSON, Moving AI .3dmap or OctoMap .bt; - "
                 "for stdin")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  app.add_option("--format", options.format, "what the file is (default: auto)")
      ->check(CLI::IsMember(formats()));
  app.add_option("--frame", options.frame, "enu or neu (default: neu for FCND tables, else enu)")
      ->check(CLI::IsMember({"enu", "neu"}));
  app.add_option("--units", options.units, "unit of the source's numbers (default m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option("--unknown", options.unknown,
                 "cells of an OctoMap that were never seen: free (default) or blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  options.skipped.add_to(app);
  options.map.add_to(app, "1 for FCND tables, else 0");
  return cli::run_tool(app, argc, argv, [&] {
    cli::InputFile file(input);
    cli::HashedInput hashed(file);
    const geom::BoxFormat format = options.format == "auto"
                                       ? geom::box_format_of(hashed.head(), file.name())
                                       : *geom::value_of(geom::kBoxFormatWords, options.format);
    options.format = name(format);
    cli::only_for(app, format == geom::BoxFormat::octomap, {"--unknown"}, "OctoMaps");
    const bool unknown_blocked = options.unknown == "blocked";
    geom::ImportedBoxes boxes =
        geom::import_boxes(hashed.stream(), format, file.name(), {unknown_blocked});
    if (!options.frame.empty()) boxes.frame.axes = *geom::axes_from_name(options.frame);
    warn(boxes, unknown_blocked, file.name(), common);
    const geom::MakeMapOptions map = map_options(options, boxes);
    nlohmann::ordered_json step = step_of(hashed.hash(), options, map);
    options.skipped.settle(boxes.skipped, file.name(), common, step);
    const geom::MadeMap made =
        geom::make_map(std::move(boxes.table), boxes.frame,
                       nlohmann::ordered_json::array({step}).dump(), file.name(), map);
    nlohmann::ordered_json stats = {{"format", options.format},
                                    {"flat", boxes.flat},
                                    {"largest_change_m", boxes.largest_change}};
    if (!boxes.skipped.empty()) stats["skipped"] = boxes.skipped.count();
    cli::write_map(common, output, made, file.name(), stats);
    return cli::Exit::yes;
  });
}
