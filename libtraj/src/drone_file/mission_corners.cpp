#include "mission_corners.h"

#include <algorithm>

#include "flown_regions.h"
#include "geom/shape/separation.h"

namespace traj {
namespace {

// Where the next points are so near that they count as reached from where the turn begins, it goes
// straight on to the first that does not.
void add_passed(std::span<const Vec3> path, std::span<const Turn> turns, std::size_t corner,
                Hull& hull) {
  const Vec3 start = before_corner(path[corner - 1], path[corner], turns[corner].radius);
  for (std::size_t j = corner + 1; j + 1 < path.size(); ++j) {
    if (turns[j].kind == Turn::rest) return;
    const geom::Aabb point{path[j], path[j]};
    if (geom::distance(start, path[corner], point) > turns[j].radius) return;
    hull.push_back(path[j]);
    hull.push_back(path[j + 1]);
  }
}

}  // namespace

Corners corners_of(std::span<const Vec3> path, std::span<const Turn> turns,
                   std::span<const FlightPart> legs, double braking_way) {
  Corners out;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (turns[i].kind == Turn::rest) continue;
    const double radius = turns[i].radius;
    ++out.count;
    out.most_radius = std::max(out.most_radius, radius);
    if (radius == 0) continue;
    const double beyond = std::max(0.0, braking_way - radius);
    Hull hull = corner_hull(path[i - 1], path[i], path[i + 1], radius, beyond);
    add_passed(path, turns, i, hull);
    out.sweeps.push_back({std::move(hull), {legs[i].item, Manoeuvre::corner}});
  }
  return out;
}

}  // namespace traj
