#include "traj/corridor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace traj {
namespace {

constexpr double kLongest = 40;        // metres, of a middle piece
constexpr double kNear = 8;            // metres, of the piece next to a corner
constexpr double kSmallGap = 1e-3;     // metres: below it the nearest points say little
constexpr double kLargestPull = 1e-3;  // metres

double lower_support(const geom::Aabb& box, const Vec3& n) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::min(n[i] * box.min[i], n[i] * box.max[i]);
  return sum;
}

// The vector from a point to the nearest point of the box.
Vec3 to_box(const Vec3& p, const geom::Aabb& box) {
  return p.cwiseMax(box.min).cwiseMin(box.max) - p;
}

// Where on the segment the distance to the box is least. The squared distance is convex and
// piecewise quadratic, so its slope is piecewise linear between the six face crossings.
double nearest_parameter(const Vec3& from, const Vec3& step, const geom::Aabb& box) {
  std::array<double, 8> knot{0, 1, 0, 0, 0, 0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    if (step[i] == 0) continue;
    knot[2 + 2 * i] = std::clamp((box.min[i] - from[i]) / step[i], 0.0, 1.0);
    knot[3 + 2 * i] = std::clamp((box.max[i] - from[i]) / step[i], 0.0, 1.0);
  }
  std::sort(knot.begin(), knot.end());
  const auto slope = [&](double t) { return -to_box(from + t * step, box).dot(step); };
  double left = slope(0);
  if (left >= 0) return 0;
  for (std::size_t k = 1; k < knot.size(); ++k) {
    const double right = slope(knot[k]);
    if (right >= 0) {
      return knot[k - 1] + (knot[k] - knot[k - 1]) * (left / (left - right));
    }
    left = right;
  }
  return 1;
}

// The plane of that direction, on whichever side of the box the segment is.
Separation across(const Vec3& normal, const Vec3& from, const Vec3& to, const geom::Aabb& box) {
  const double support = lower_support(box, normal);
  const double gap = support - std::max(normal.dot(from), normal.dot(to));
  return {{normal, support - std::clamp(gap / 2, 0.0, kLargestPull)}, gap};
}

Separation best_axis(const Vec3& from, const Vec3& to, const geom::Aabb& box) {
  Separation best;
  best.gap = -std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& axis) {
    const double size = axis.norm();
    if (!(size > 0)) return;
    for (const double sign : {1.0, -1.0}) {
      const Separation s = across(axis * (sign / size), from, to, box);
      if (s.gap > best.gap) best = s;
    }
  };
  for (int i = 0; i < 3; ++i) consider(Vec3::Unit(i));
  for (int i = 0; i < 3; ++i) consider((to - from).cross(Vec3::Unit(i)));
  return best;
}

// The six faces of the bounds as planes, pulled in like the others.
std::vector<Separation> bound_planes(const CorridorPiece& piece, const geom::Aabb& inner) {
  std::vector<Separation> planes;
  for (int i = 0; i < 3; ++i) {
    const double up = inner.max[i] - std::max(piece.from[i], piece.to[i]);
    const double down = std::min(piece.from[i], piece.to[i]) - inner.min[i];
    const auto pull = [](double gap) { return std::clamp(gap / 2, 0.0, kLargestPull); };
    planes.push_back({{Vec3::Unit(i), inner.max[i] - pull(up)}, up});
    planes.push_back({{-Vec3::Unit(i), -inner.min[i] - pull(down)}, down});
  }
  return planes;
}

geom::Aabb around(const CorridorPiece& piece, double reach) {
  const Vec3 pad = Vec3::Constant(reach);
  return {piece.from.cwiseMin(piece.to) - pad, piece.from.cwiseMax(piece.to) + pad};
}

bool behind_any(const geom::Aabb& box, const CorridorPiece& piece) {
  return std::any_of(piece.planes.begin(), piece.planes.end(),
                     [&](const Plane& plane) { return behind(box, plane); });
}

struct Near {
  Separation separation;
  std::optional<geom::Aabb> box;  // none for a bound
};

std::vector<Near> near_by(const geom::CollisionScene& scene, const CorridorPiece& piece,
                          double reach) {
  std::vector<Near> near;
  for (const std::size_t i : scene.boxes_meeting(around(piece, reach))) {
    const geom::Aabb box = scene.grown(i);
    const Separation s = separation(piece.from, piece.to, box);
    if (s.gap <= reach) near.push_back({s, box});
  }
  if (scene.free_bounds()) {
    for (const Separation& s : bound_planes(piece, *scene.free_bounds())) {
      if (s.gap <= reach) near.push_back({s, std::nullopt});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.separation.gap < b.separation.gap;
  });
  return near;
}

// `from` to `to` without `from`.
void append_cuts(const Vec3& from, const Vec3& to, geom::Polyline& out) {
  const double length = (to - from).norm();
  const Vec3 direction = (to - from) / length;
  if (length > 10 && length <= 20) {
    out.push_back(0.5 * (from + to));
  } else if (length > 20) {
    const double middle = length - 2 * kNear;
    const double count = std::ceil(middle / kLongest);
    for (double k = 0; k <= count; ++k) {
      out.push_back(from + (kNear + middle * (k / count)) * direction);
    }
  }
  out.push_back(to);
}

bool has_plane(const CorridorPiece& piece, const Plane& plane) {
  return std::any_of(piece.planes.begin(), piece.planes.end(), [&](const Plane& other) {
    return other.normal == plane.normal && other.offset == plane.offset;
  });
}

}  // namespace

Separation separation(const Vec3& from, const Vec3& to, const geom::Aabb& box) {
  const Vec3 step = to - from;
  const Vec3 p = from + nearest_parameter(from, step, box) * step;
  const Vec3 gap = to_box(p, box);
  const double distance = gap.norm();
  if (distance >= kSmallGap) {
    const Separation s = across(gap / distance, from, to, box);
    if (s.gap >= kSmallGap / 2) return s;
  }
  return best_axis(from, to, box);
}

bool behind(const geom::Aabb& box, const Plane& plane) {
  return lower_support(box, plane.normal) > plane.offset;
}

geom::Polyline joints(const geom::Polyline& path) {
  geom::Polyline out{path.front()};
  for (const Vec3& p : path) {
    if (p != out.back()) append_cuts(Vec3(out.back()), p, out);
  }
  if (out.size() < 2) return {};
  const Vec3 first = out[0] + 0.25 * (out[1] - out[0]);
  const Vec3 last = out.back() + 0.25 * (out[out.size() - 2] - out.back());
  out.insert(out.begin() + 1, first);
  out.insert(out.end() - 1, last);
  return out;
}

Corridor pieces_between(const geom::Polyline& points) {
  Corridor corridor;
  for (std::size_t i = 1; i < points.size(); ++i)
    corridor.push_back({points[i - 1], points[i], {}});
  return corridor;
}

void add_planes(const geom::CollisionScene& scene, double reach, Corridor& corridor) {
  for (CorridorPiece& piece : corridor) {
    for (const Near& near : near_by(scene, piece, reach)) {
      if (near.box && behind_any(*near.box, piece)) continue;
      piece.planes.push_back(near.separation.plane);
    }
  }
}

std::size_t add_planes_met(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           Corridor& corridor) {
  assert(trajectory.segments.size() == corridor.size());
  std::size_t added = 0;
  for (std::size_t i = 0; i < corridor.size(); ++i) {
    CorridorPiece& piece = corridor[i];
    const geom::Aabb hull = *geom::bounds(trajectory.segments[i].point);
    const auto add = [&](const Plane& plane) {
      if (has_plane(piece, plane)) return;
      piece.planes.push_back(plane);
      ++added;
    };
    for (const std::size_t b : scene.boxes_meeting(hull)) {
      const geom::Aabb box = scene.grown(b);
      if (!behind_any(box, piece)) add(separation(piece.from, piece.to, box).plane);
    }
    if (!scene.free_bounds()) continue;
    for (const Separation& s : bound_planes(piece, *scene.free_bounds())) {
      const auto outside = [&](const Vec3& p) { return s.plane.normal.dot(p) > s.plane.offset; };
      if (outside(hull.min) || outside(hull.max)) add(s.plane);
    }
  }
  return added;
}

}  // namespace traj
