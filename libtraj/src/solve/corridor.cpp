#include "traj/solve/corridor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "bound_planes.h"

namespace traj {
namespace {

constexpr double kLongest = 40;  // metres, of a middle piece
constexpr double kNear = 8;      // metres, of the piece next to a corner
constexpr int kMostHalvings = 60;
constexpr std::size_t kMostMet = 1000;  // obstacles that a stray curve is held apart from at once

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

void sort_nearest_first(std::vector<Near>& near) {
  std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.separation.gap < b.separation.gap;
  });
}

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
  sort_nearest_first(near);
  return near;
}

// The obstacles that meet `hull`, which may hold a good part of a city where the curve went astray:
// of more than kMostMet only those towards the piece.
std::vector<Near> met(const geom::CollisionScene& scene, const CorridorPiece& piece,
                      geom::Aabb hull) {
  const geom::Aabb own = around(piece, 0);
  auto boxes = scene.boxes_meeting(hull, kMostMet);
  for (int i = 0; i < kMostHalvings && !boxes; ++i) {
    hull = {0.5 * (hull.min + own.min), 0.5 * (hull.max + own.max)};
    boxes = scene.boxes_meeting(hull, kMostMet);
  }
  std::vector<Near> near;
  for (const std::size_t i : boxes ? *boxes : scene.boxes_meeting(own)) {
    const geom::Aabb box = scene.grown(i);
    near.push_back({separation(piece.from, piece.to, box), box});
  }
  sort_nearest_first(near);
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

// A bend in place of the last of `way` and of `p`, on the outer side of their turn.
std::optional<Vec3> one_bend(const geom::CollisionScene& scene, const geom::Polyline& way,
                             std::span<const Vec3, 2> ahead, double least) {
  if (way.size() < 2) return std::nullopt;
  const Vec3& p = ahead[0];
  const Vec3& next = ahead[1];
  const Vec3& before = way[way.size() - 2];
  const Vec3 middle = 0.5 * (way.back() + p);
  const Vec3 out = (middle - before).normalized() + (middle - next).normalized();
  for (const double far : {0.5, 1.0, 2.0}) {
    const Vec3 bend = middle + far * least * out.normalized();
    if (scene.free(before, bend) && scene.free(bend, next)) return bend;
  }
  return std::nullopt;
}

bool has_plane(const CorridorPiece& piece, const Plane& plane) {
  return std::any_of(piece.planes.begin(), piece.planes.end(), [&](const Plane& other) {
    return other.normal == plane.normal && other.offset == plane.offset;
  });
}

}  // namespace

geom::Polyline without_short_legs(const geom::CollisionScene& scene, const geom::Polyline& path,
                                  double least) {
  geom::Polyline out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3& p = path[i];
    if (out.empty() || (p - out.back()).norm() >= least) {
      out.push_back(p);
    } else if (out.size() > 1 && scene.free(out[out.size() - 2], p)) {
      out.back() = p;
    } else if (i + 1 == path.size()) {
      out.push_back(p);
    } else if (scene.free(out.back(), path[i + 1])) {
      continue;
    } else if (const auto one =
                   one_bend(scene, out, std::span(path).subspan(i).first<2>(), least)) {
      out.back() = *one;
    } else {
      out.push_back(p);
    }
  }
  return out;
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
    for (const Near& near : met(scene, piece, hull)) {
      if (!behind_any(*near.box, piece)) add(near.separation.plane);
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
