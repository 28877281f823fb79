// Looking at maps: info, to-csv, to-geojson, to-sdf.

#include "cli/content/describe.h"
#include "cli/file/files.h"
#include "geom/import/box_csv.h"
#include "geom/map/box_geojson.h"
#include "geom/map/box_sdf.h"
#include "geom/map/join.h"
#include "geom/map/statistics.h"
#include "geom/text/counted.h"
#include "verbs.h"

namespace verbs {
namespace {

using geom::BoxMap;
using Json = nlohmann::ordered_json;

constexpr std::size_t kCollisionBytes = 150;  // a box, about
constexpr std::size_t kManyBoxes = 1000000;   // beyond, overlaps are counted when asked for

Json quartet(const geom::Quartet& q) {
  return {{"min", q.least}, {"median", q.median}, {"mean", q.mean}, {"max", q.most}};
}

// The steps of the history that say what unknown space became.
Json unknown_of(const BoxMap& map) {
  Json out = Json::array();
  for (const Json& step : cli::history_of(map)) {
    if (step.is_object() && step.contains("unknown")) out.push_back(step["unknown"]);
  }
  return out;
}

Json description(const BoxMap& map, bool all) {
  Json out = cli::describe(map);
  const Json history = out["history"];
  out.erase("history");
  const geom::MapStatistics stats = geom::statistics(map);
  out["heights_m"] = quartet(stats.height);
  out["boxes_per_tile"] = quartet(stats.boxes_per_tile);
  out["flat"] = stats.flat;
  if (all || map.size() <= kManyBoxes) {
    const geom::Overlaps overlaps = geom::overlaps(map);
    out["overlapping_pairs"] = overlaps.pairs;
    out["contained"] = overlaps.contained;
  }
  const Json unknown = unknown_of(map);
  if (!unknown.empty()) out["unknown"] = unknown;
  if (stats.unknown > 0) out["unknown_boxes"] = stats.unknown;
  out["file_bytes"] = map.size() * (sizeof(geom::Aabb) + 12);
  out["collision_bytes"] = map.size() * kCollisionBytes;  // once every tile is touched
  out["history"] = history;
  return out;
}

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
            const Json out = description(map, flags->all);
            cli::OutputFile file(files->output, cli::OutputKind::text);
            file.stream() << (flags->json ? out.dump() + '\n' : cli::as_lines(out));
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
