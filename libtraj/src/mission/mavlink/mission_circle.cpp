#include "mission_circle.h"

#include <fmt/format.h>

#include <cmath>

#include "mission_jumps.h"

namespace traj {

double require_radius(const MissionItem& item, double radius, std::string_view source) {
  if (radius <= 1e4) return radius;
  refuse_item(source, item,
              {.key = "a radius", .expected = "within 1e4 m", .found = fmt::to_string(radius)});
}

void require_whole_turns(const MissionItem& item, std::string_view source) {
  const double turns = item.param[0];
  if (!(turns >= 1 && turns <= 1e6) || turns != std::floor(turns)) {
    refuse_item(
        source, item,
        {.expected = "whole turns on a circle, at least one", .found = fmt::to_string(turns)});
  }
}

Circle circle_of(const MissionItem& item, const Vec3& centre, std::string_view source) {
  const double radius = require_radius(item, std::abs(item.param[2]), source);
  if (!(radius > 0)) {
    refuse_item(source, item,
                {.expected = "the radius of the circle",
                 .found = "0",
                 .advice = "it would be the vehicle's own"});
  }
  const double unit = radius > 255 ? 10 : 1;
  if (radius != unit * std::floor(radius / unit)) {
    refuse_item(
        source, item,
        {.expected = "a radius of whole metres, or of tens above 255, as ArduPilot keeps it",
         .found = fmt::to_string(radius)});
  }
  return {centre, radius};
}

void require_known_entry(const Circle& circle, const Hull& from, const MissionItem& item,
                         std::string_view source) {
  if (from.size() > 2) {
    refuse_item(source, item,
                {.expected = "a waypoint with a hold before a circle",
                 .found = "several that count as reached at once"});
  }
  for (const Vec3& p : from) {
    if ((p - circle.centre).head<2>().norm() >= 0.5 * circle.radius) continue;
    refuse_item(source, item,
                {.expected = "to come to the circle from outside of half its radius",
                 .found = "a point nearer to its centre",
                 .advice = "where the circle begins is uncertain"});
  }
}

}  // namespace traj
