#include "mission_corners.h"

#include <algorithm>
#include <cmath>

#include "mission/flown/flown_regions.h"
#include "mission_autopilots.h"

namespace traj {
namespace {

// Where the next points are so near that they may count as reached while it turns, it goes straight
// on to the first that does not, from anywhere, and turns there.
void add_passed(std::span<const Vec3> path, std::span<const Turn> turns, std::size_t corner,
                Hull& hull) {
  std::size_t last = corner;
  for (std::size_t j = corner + 1; j + 1 < path.size(); ++j) {
    if (turns[j].kind == Turn::rest) break;
    if ((path[j] - path[corner]).norm() > turns[corner].radius + turns[j].radius) break;
    hull.push_back(path[j]);
    hull.push_back(path[j + 1]);
    last = j + 1;
  }
  if (last == corner || last + 1 >= path.size() || turns[last].kind == Turn::rest) return;
  hull.push_back(before_corner(path[last + 1], path[last], turns[last].radius));
}

}  // namespace

Turn turn_at(const MissionItem& item, double hold, const MissionRules& rules) {
  const double said = item.command == kWaypoint && item.param[1] > 0 ? item.param[1] : 0;
  const double usual = rules.acceptance.value_or(said > 0 ? kLeastAcceptance : kAcceptance);
  const double held = said > 0 ? said : rules.acceptance.value_or(kAcceptance);
  if (hold >= 1 && flown_by(Firmware::ardupilot, rules)) return {.said = said};
  if (hold >= 1 && hold >= 2 * std::sqrt(2 * held / rules.braking)) return {.said = said};
  return {Turn::pass, std::max(usual, said), said > 0 ? std::min(usual, said) : usual, said};
}

Corners corners_of(std::span<const Vec3> path, std::span<const Turn> turns,
                   std::span<const FlightPart> legs, double braking_way) {
  Corners out;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (turns[i].kind == Turn::rest) continue;
    const double radius = turns[i].radius;
    ++out.count;
    out.most_radius = std::max(out.most_radius, radius);
    if (radius == 0) continue;
    const double beyond = std::max(0.0, braking_way - turns[i].least);
    Hull hull = corner_hull(path[i - 1], path[i], path[i + 1], radius, beyond);
    for (const Vec3& from : turns[i].from) {
      const Hull other = corner_hull(from, path[i], path[i + 1], radius, beyond);
      hull.insert(hull.end(), other.begin(), other.end());
    }
    add_passed(path, turns, i, hull);
    out.sweeps.push_back({std::move(hull), {legs[i].item, Manoeuvre::corner}});
  }
  return out;
}

}  // namespace traj
