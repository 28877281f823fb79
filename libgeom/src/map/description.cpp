#include "geom/map/description.h"

#include <nlohmann/json.hpp>

#include "geom/map/map_doubts.h"
#include "geom/map/map_draft.h"
#include "geom/map/statistics.h"
#include "geom/text/excerpt.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kCollisionBytes = 150;  // a box, about

Json corner(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json quartet(const Quartet& q) {
  return {{"min", q.least}, {"median", q.median}, {"mean", q.mean}, {"max", q.most}};
}

// The steps of the history that say what unknown space became.
Json unknown_of(const Json& history) {
  Json out = Json::array();
  for (const Json& step : history) {
    if (step.is_object() && step.contains("unknown")) out.push_back(step["unknown"]);
  }
  return out;
}

}  // namespace

Json description(const BoxMap& map) {
  const BoxMapSpec& spec = map.spec();
  Json out = {{"type", "boxmap"},
              {"hash", map.hash()},
              {"boxes", map.size()},
              {"tiles", map.tile_count()},
              {"tile_size_m", spec.tile_size},
              {"frame", name(spec.frame.axes)},
              {"bounds_min_m", corner(spec.bounds.min)},
              {"bounds_max_m", corner(spec.bounds.max)},
              {"bounds_from", spec.bounds_from},
              {"labels", map.labels().size() - 1}};
  if (spec.frame.origin) {
    out["origin"] = {{"latitude_deg", spec.frame.origin->latitude},
                     {"longitude_deg", spec.frame.origin->longitude},
                     {"height_m", spec.frame.origin->height}};
  }
  if (!spec.frame.crs.empty()) out["crs"] = spec.frame.crs;
  if (spec.epoch) out["epoch"] = *spec.epoch;
  if (!map.timed().empty()) out["timed_boxes"] = map.timed().size();
  if (const std::size_t skipped = skipped_in(spec)) out["skipped_obstacles"] = skipped;
  if (const double gap = doubts_of(spec).gap; gap > 0) out["share_in_no_joined_map"] = gap;
  out["history"] =
      parse_ordered_json(spec.history.empty() ? "[]" : spec.history, "the map's history");
  return out;
}

Json full_description(const BoxMap& map, bool pairs) {
  Json out = description(map);
  const Json history = out["history"];
  out.erase("history");
  const MapStatistics stats = statistics(map);
  out["heights_m"] = quartet(stats.height);
  out["boxes_per_tile"] = quartet(stats.boxes_per_tile);
  out["flat"] = stats.flat;
  if (pairs) {
    const Overlaps found = overlaps(map);
    out["overlapping_pairs"] = found.pairs;
    out["contained"] = found.contained;
  }
  const Json unknown = unknown_of(history);
  if (!unknown.empty()) out["unknown"] = unknown;
  if (stats.unknown > 0) out["unknown_boxes"] = stats.unknown;
  out["file_bytes"] = map.size() * (sizeof(Aabb) + 12);
  out["collision_bytes"] = map.size() * kCollisionBytes;  // once every tile is touched
  out["history"] = history;
  return out;
}

std::string as_lines(const Json& object) {
  std::string text;
  for (const auto& [key, value] : object.items()) {
    text += printable(key) + ": " +
            (value.is_string() ? printable(value.get<std::string>()) : printable(value.dump())) +
            '\n';
  }
  return text;
}

}  // namespace geom
