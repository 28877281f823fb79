#include "describe.h"

#include "cli/option/skipped_option.h"
#include "geom/text/excerpt.h"
#include "geom/text/parse_json.h"

namespace cli {
namespace {

nlohmann::ordered_json corner(const geom::Vec3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

nlohmann::ordered_json describe(const geom::BoxMap& map) {
  const geom::BoxMapSpec& spec = map.spec();
  nlohmann::ordered_json out = {{"type", "boxmap"},
                                {"hash", map.hash()},
                                {"boxes", map.size()},
                                {"tiles", map.tile_count()},
                                {"tile_size_m", spec.tile_size},
                                {"frame", geom::name(spec.frame.axes)},
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
  out["history"] = history_of(map);
  return out;
}

nlohmann::ordered_json history_of(const geom::BoxMap& map) {
  const std::string& history = map.spec().history;
  return geom::parse_ordered_json(history.empty() ? "[]" : history, "the map's history");
}

std::string as_lines(const nlohmann::ordered_json& object) {
  std::string text;
  for (const auto& [key, value] : object.items()) {
    text += geom::printable(key) + ": " +
            (value.is_string() ? geom::printable(value.get<std::string>())
                               : geom::printable(value.dump())) +
            '\n';
  }
  return text;
}

}  // namespace cli
