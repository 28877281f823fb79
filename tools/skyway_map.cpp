// skyway-map: look at box maps and make others of them.

#include "cli/describe.h"
#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/run.h"
#include "geom/error.h"
#include "geom/io/box_csv.h"
#include "geom/io/box_map_file.h"

namespace {

using geom::BoxMap;

geom::BoxTable table_of(const BoxMap& map, const std::optional<geom::Aabb>& region) {
  geom::BoxTable table;
  table.labels = map.labels();
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (region && !geom::overlap(map.boxes()[i], *region)) continue;
    table.boxes.push_back(map.boxes()[i]);
    table.ids.push_back(map.ids()[i]);
    table.label.push_back(map.label()[i]);
  }
  return table;
}

// The boxes that meet the region, whole, and the part of the bounds inside it.
BoxMap crop(const BoxMap& map, const geom::Aabb& region, const std::string& name) {
  geom::BoxMapSpec spec = map.spec();
  spec.bounds = {spec.bounds.min.cwiseMax(region.min), spec.bounds.max.cwiseMin(region.max)};
  if ((spec.bounds.min.array() >= spec.bounds.max.array()).any()) {
    throw geom::InputError(name,
                           "the map's bounds and the region to crop to have no volume in common");
  }
  auto history = nlohmann::ordered_json::parse(spec.history);
  history.push_back({{"tool", "skyway-map crop"},
                     {"input", map.hash()},
                     {"bounds",
                      {region.min[0], region.min[1], region.min[2], region.max[0], region.max[1],
                       region.max[2]}}});
  spec.history = history.dump();
  return BoxMap(spec, table_of(map, region));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Look at a box map, crop it, or write its boxes as CSV.", "skyway-map"};
  cli::Common common(app);
  std::string map_file;
  std::string output = "-";
  std::optional<geom::Aabb> region;
  bool json = false;
  CLI::App* info = app.add_subcommand("info", "print what is in the map");
  info->add_flag("--json", json, "as one JSON object");
  CLI::App* crop_verb = app.add_subcommand("crop", "keep the boxes that meet a region");
  cli::add_box(*crop_verb, "--bounds", region, "the region to keep")->required();
  CLI::App* to_csv = app.add_subcommand("to-csv", "write the boxes as box CSV");
  for (CLI::App* verb : {info, crop_verb, to_csv}) {
    verb->fallthrough();
    verb->add_option("map", map_file, "box map; - for stdin")->required();
    verb->add_option("-o,--output", output, "file to write (default: stdout)");
  }
  app.require_subcommand(1);
  return cli::run_tool(app, argc, argv, [&] {
    const BoxMap map = cli::open_map(map_file);
    const bool artefact = crop_verb->parsed();
    cli::OutputFile out(output, artefact ? cli::OutputKind::artefact : cli::OutputKind::text);
    if (artefact) {
      geom::write_box_map(out.stream(), crop(map, *region, map_file));
    } else if (to_csv->parsed()) {
      geom::write_box_csv(out.stream(), table_of(map, std::nullopt));
    } else {
      const auto description = cli::describe(map);
      out.stream() << (json ? description.dump() + '\n' : cli::as_lines(description));
    }
    out.commit();
    return cli::Exit::yes;
  });
}
