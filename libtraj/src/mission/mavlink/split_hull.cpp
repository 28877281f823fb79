#include "split_hull.h"

#include "geom/shape/aabb.h"

namespace traj {
namespace {

constexpr std::size_t kMostPoints = 32;

Hull corners_of(const geom::Aabb& box) {
  Hull out;
  for (int i = 0; i < 8; ++i) {
    out.emplace_back((i & 1 ? box.max : box.min).x(), (i & 2 ? box.max : box.min).y(),
                     (i & 4 ? box.max : box.min).z());
  }
  return out;
}

// The points on one side of a plane across an axis, and all at which the hull crosses it: the
// hull's section is the hull of where its points' connections cross.
Hull part_below(const Hull& hull, int axis, double plane, double sign) {
  Hull out;
  for (const Vec3& p : hull) {
    if (sign * (p[axis] - plane) <= 0) out.push_back(p);
  }
  for (const Vec3& p : hull) {
    if (p[axis] >= plane) continue;
    for (const Vec3& q : hull) {
      if (q[axis] <= plane) continue;
      Vec3 crossing = p + (q - p) * ((plane - p[axis]) / (q[axis] - p[axis]));
      crossing[axis] = plane;
      out.push_back(crossing);
    }
  }
  return out.size() > kMostPoints ? corners_of(*geom::bounds(out)) : out;
}

void split(const Hull& hull, double most, std::vector<Hull>& out) {
  const geom::Aabb box = *geom::bounds(hull);
  const Vec3 size = box.max - box.min;
  const int axis = size.x() >= size.y() ? 0 : 1;
  if (size[axis] <= most) {
    out.push_back(hull);
    return;
  }
  const double middle = box.min[axis] + size[axis] / 2;
  split(part_below(hull, axis, middle, 1), most, out);
  split(part_below(hull, axis, middle, -1), most, out);
}

}  // namespace

std::vector<Hull> split_hull(const Hull& hull, double most) {
  std::vector<Hull> out;
  split(hull, most, out);
  return out;
}

}  // namespace traj
