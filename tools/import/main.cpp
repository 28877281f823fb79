// skyway-import: city tables, block texts, voxels and octrees become box maps.

#include <fmt/format.h>

#include <sstream>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "cli/file/map_output.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/import/block_text.h"
#include "geom/import/box_csv.h"
#include "geom/import/fcnd_csv.h"
#include "geom/import/octomap.h"
#include "geom/import/voxel_3dmap.h"
#include "geom/import/world_json.h"
#include "geom/map/make_map.h"

namespace {

struct Source {
  geom::BoxTable table;
  geom::Frame frame;
  std::size_t flat = 0;
  double largest_change = 0;
  geom::Skipped skipped;
};

struct Options {
  std::string format = "auto";
  std::string frame;
  std::string units = "m";
  std::string unknown = "free";
  cli::SkippedOption skipped;
  cli::MapOptions map;
};

const std::vector<std::string> kFormats = {"auto",       "fcnd",  "box-csv", "block-text",
                                           "world-json", "3dmap", "octomap"};

// "auto": what the first line with something in it looks like; nothing where it is none of these.
std::optional<std::string> detect(std::string_view head) {
  if (head.starts_with("# Octomap")) return "octomap";
  std::istringstream in{std::string(head)};
  for (std::string line; std::getline(in, line);) {
    if (line.find("min_x_m") != std::string::npos) return "box-csv";
    const std::size_t at = line.find_first_not_of(" \t\r");
    if (at == std::string::npos || line[at] == '#') continue;
    const std::string_view text = std::string_view(line).substr(at);
    if (text.starts_with("boundary") || text.starts_with("block")) return "block-text";
    if (text.starts_with("voxel")) return "3dmap";
    if (text.starts_with("{")) return "world-json";
    const bool table =
        text.find("pos") != std::string::npos || text.find("half") != std::string::npos;
    const bool numbers = text.find_first_of("0123456789") < 2;
    if (table || numbers || text.starts_with("lat0") || text.starts_with("\xef\xbb\xbf"))
      return "fcnd";
    return std::nullopt;
  }
  return "fcnd";
}

std::string detected(std::string_view head, const std::string& source) {
  if (const auto format = detect(head)) return *format;
  throw geom::InputError(
      source, 1,
      fmt::format(
          "expected an FCND table, box CSV, block text, RotorPy JSON, .3dmap or OctoMap .bt "
          "(or --format), found \"{}\"",
          head.substr(0, std::min<std::size_t>(60, head.find_first_of("\r\n")))));
}

Source read_fcnd(std::istream& in, const std::string& name, geom::MakeMapOptions& map) {
  geom::FcndTable fcnd = geom::read_fcnd_csv(in, name);
  if (!map.floor) map.floor = 0;
  return {std::move(fcnd.table),
          {geom::Axes::neu, fcnd.origin, ""},
          fcnd.flat,
          fcnd.largest_change,
          std::move(fcnd.skipped)};
}

Source read_block_text(std::istream& in, const std::string& name, geom::MakeMapOptions& map) {
  geom::BlockText block = geom::read_block_text(in, name);
  map.source_bounds = block.boundary;
  return {std::move(block.table), {}, block.flat, 0, std::move(block.skipped)};
}

Source read_world_json(std::istream& in, const std::string& name, geom::MakeMapOptions& map,
                       const cli::Common& common) {
  geom::WorldJson world = geom::read_world_json(in, name);
  for (const std::string& key : world.names) common.warn(name + ": unknown key, " + key);
  map.source_bounds = world.bounds;
  return {std::move(world.table), {}, world.flat, 0, std::move(world.skipped)};
}

Source read_3dmap(std::istream& in, const std::string& name, geom::MakeMapOptions& map) {
  geom::VoxelMap voxels = geom::read_voxel_3dmap(in, name);
  map.source_bounds = voxels.bounds;
  return {std::move(voxels.table), {}, 0, 0, {}};
}

Source read_octomap(std::istream& in, const std::string& name, const Options& options,
                    geom::MakeMapOptions& map, const cli::Common& common) {
  geom::Octomap tree = geom::read_octomap(in, name, {options.unknown == "blocked"});
  map.source_bounds = tree.bounds;
  if (tree.unknown > 0 && options.unknown == "free") {
    common.warn(
        fmt::format("{}: {} cell(s) within the bounds were never seen and count as free "
                    "(--unknown blocked makes them obstacles)",
                    name, tree.unknown));
  }
  return {std::move(tree.table), {}, 0, 0, {}};
}

Source read(std::istream& in, const std::string& name, const Options& options,
            geom::MakeMapOptions& map, const cli::Common& common) {
  Source source;
  if (options.format == "fcnd") source = read_fcnd(in, name, map);
  if (options.format == "box-csv") source.table = geom::read_box_csv(in, name);
  if (options.format == "block-text") source = read_block_text(in, name, map);
  if (options.format == "world-json") source = read_world_json(in, name, map, common);
  if (options.format == "3dmap") source = read_3dmap(in, name, map);
  if (options.format == "octomap") source = read_octomap(in, name, options, map, common);
  if (!options.frame.empty()) source.frame.axes = *geom::axes_from_name(options.frame);
  return source;
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
      ->check(CLI::IsMember(kFormats));
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
    if (options.format == "auto") options.format = detected(hashed.head(), file.name());
    cli::only_for(app, options.format == "octomap", {"--unknown"}, "OctoMaps");
    geom::MakeMapOptions map = options.map.make(options.format == "fcnd" ? 1 : 0);
    map.scale *= cli::kMetres.at(options.units);
    Source source = read(hashed.stream(), file.name(), options, map, common);
    if (source.flat > 0)
      common.warn(fmt::format("{}: {} flat box(es) kept", file.name(), source.flat));
    nlohmann::ordered_json step = step_of(hashed.hash(), options, map);
    options.skipped.settle(source.skipped, file.name(), common, step);
    const geom::MadeMap made =
        geom::make_map(std::move(source.table), source.frame,
                       nlohmann::ordered_json::array({step}).dump(), file.name(), map);
    nlohmann::ordered_json stats = {{"format", options.format},
                                    {"flat", source.flat},
                                    {"largest_change_m", source.largest_change}};
    if (!source.skipped.empty()) stats["skipped"] = source.skipped.count();
    cli::write_map(common, output, made, file.name(), stats);
    return cli::Exit::yes;
  });
}
