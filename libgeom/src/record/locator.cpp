#include "geom/record/locator.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

constexpr double kFar = 1e6;  // metres

bool says(const nlohmann::json& step, const char* key, std::string_view word) {
  const auto at = step.find(key);
  return at != step.end() && at->is_string() && at->get_ref<const std::string&>() == word;
}

// Whether a history, or one in it, has a scan or a height model, where a place without a box is one
// without data.
bool has_scan(const nlohmann::json& history) {
  if (history.is_object() &&
      (says(history, "tool", "skyway-cloud") || says(history, "format", "raster"))) {
    return true;
  }
  return history.is_structured() && std::any_of(history.begin(), history.end(), has_scan);
}

}  // namespace

Locator::Locator(const BoxMap& map) : map_(map) {
  const Frame& frame = map.spec().frame;
  if (counts_from_origin(frame)) earth_.emplace(*frame.origin);
  const std::string& history = map.spec().history;
  scanned_ = !history.empty() && has_scan(parse_json(history, "the map's history"));
}

double Locator::zero() const {
  const auto& origin = map_.spec().frame.origin;
  return origin ? origin->height : 0;
}

// The top of what stands there, if anything does.
std::optional<double> Locator::top(const Vec3& p) const {
  std::optional<double> top;
  const auto under = [&](const Aabb& box) {
    return box.min.x() <= p.x() && p.x() <= box.max.x() && box.min.y() <= p.y() &&
           p.y() <= box.max.y();
  };
  const auto tiles = map_.tiles();
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (!under(tiles[t].extent)) continue;
    for (const Aabb& box : map_.boxes_of(t)) {
      if (under(box)) top = std::max(top.value_or(box.max.z()), box.max.z());
    }
  }
  return top;
}

Vec3 Locator::at(const Place& place, std::string_view source, std::size_t line) const {
  if (const auto* metres = std::get_if<Vec3>(&place)) return *metres;
  const auto& there = std::get<EarthPlace>(place);
  if (!earth_) {
    throw InputError(
        source, line,
        {.says = "a place in degrees has no place on a map that does not say where on Earth it is",
         .advice = "give metres, or make the map anew with an origin"});
  }
  Vec3 enu(0, 0, 0);
  earth_->from_geodetic(there.latitude, there.longitude, enu.x(), enu.y());
  if (!(enu.norm() <= kFar)) {
    throw InputError(
        source, line,
        {.says = fmt::format("latitude {}, longitude {} is more than 1000 km from the map, which "
                             "is at latitude {}, longitude {}",
                             there.latitude, there.longitude, map_.spec().frame.origin->latitude,
                             map_.spec().frame.origin->longitude)});
  }
  Vec3 p = to_enu(map_.spec().frame.axes, enu);
  p.z() = there.height;
  if (!there.above) return p;
  const auto under = top(p);
  if (!under && scanned_) {
    throw InputError(
        source, line,
        {.says = fmt::format("nothing was scanned under latitude {}, longitude {}, so no ground is "
                             "known that a height could be above",
                             there.latitude, there.longitude),
         .advice = "give a height in the map's z"});
  }
  p.z() += under.value_or(map_.spec().bounds.min.z());
  return p;
}

}  // namespace geom
