// Looking at maps: info, to-csv, to-geojson, to-sdf.

#include "cli/file/files.h"
#include "geom/import/box_csv.h"
#include "geom/map/box_geojson.h"
#include "geom/map/box_sdf.h"
#include "geom/map/description.h"
#include "geom/map/join.h"
#include "geom/text/counted.h"
#include "verbs.h"

namespace verbs {
namespace {

using geom::BoxMap;

constexpr std::size_t kManyBoxes = 1000000;  // beyond, overlaps are counted when asked for

}  // namespace

void warn_of_times(const std::string& name, const BoxMap& map, const cli::Common& common) {
  if (map.timed().empty()) return;
  common.warn(name + ": " + geom::counted(map.timed().size(), "box is", "boxes are") +
              " there for a time only, which the file written does not say");
}

Verb info(CLI::App& app, const cli::Common& common) {
  struct Flags {
    bool json = false;
    bool all = false;
  };
  auto files = std::make_shared<Files>();
  auto flags = std::make_shared<Flags>();
  CLI::App* verb = files->add(app, "info", "print what is in the map");
  verb->add_flag("--json", flags->json, "print one JSON object");
  verb->add_flag("--all", flags->all, "count overlaps on maps of over a million boxes too");
  return {verb, [=, &common] {
            const BoxMap map =
                cli::open_map(files->map, geom::Verified::extents, common.execution("verify"));
            const auto out = geom::full_description(map, flags->all || map.size() <= kManyBoxes);
            cli::OutputFile file(files->output, cli::OutputKind::text);
            file.stream() << (flags->json ? out.dump() + '\n' : geom::as_lines(out));
            file.commit();
            return cli::Exit::yes;
          }};
}

Verb to_csv(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  CLI::App* verb = files->add(app, "to-csv", "write the boxes as box CSV");
  return {verb, [=, &common] {
            const BoxMap map = open(files->map, common);
            cli::OutputFile out(files->output, cli::OutputKind::text);
            geom::write_box_csv(out.stream(), geom::table_of(map));
            out.commit();
            return cli::Exit::yes;
          }};
}

Verb to_geojson(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  CLI::App* verb =
      files->add(app, "to-geojson", "write the boxes as GeoJSON, in degrees, with base and height");
  return {verb, [=, &common] {
            const BoxMap map = open(files->map, common);
            cli::OutputFile out(files->output, cli::OutputKind::text);
            geom::write_box_geojson(out.stream(), map, files->map);
            out.commit();
            return cli::Exit::yes;
          }};
}

Verb to_sdf(CLI::App& app, const cli::Common& common) {
  auto files = std::make_shared<Files>();
  CLI::App* verb =
      files->add(app, "to-sdf", "write the boxes as a Gazebo world, to fly in the simulator");
  return {verb, [=, &common] {
            const BoxMap map = open(files->map, common);
            cli::OutputFile out(files->output, cli::OutputKind::text);
            const std::size_t larger = geom::write_box_sdf(out.stream(), map);
            out.commit();
            warn_of_times(files->map, map, common);
            if (larger > 0) {
              common.warn(files->map + ": " + geom::counted(larger, "box is", "boxes are") +
                          " larger by rounding than in the map");
            }
            return cli::Exit::yes;
          }};
}

}  // namespace verbs
