#include "half_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <span>

namespace plan {
namespace {

constexpr double kOff = 1e-3;  // metres that bends keep from boxes
constexpr int kRounds = 40;    // at most; most need fewer than ten

struct Leg {
  Flat end;
  bool free;  // known to be, from the end of the leg before
};

// Points of the boxes that the leg meets, above the base and between its ends.
void add_points(const geom::CollisionScene& scene, const HalfPlane& half,
                std::span<const std::size_t> boxes, std::vector<Flat>& out) {
  for (const std::size_t i : boxes) {
    geom::Aabb box = scene.grown(i);
    box.min.array() -= kOff;
    box.max.array() += kOff;
    for_edges_through(box, half.from, half.normal, [&](const Vec3& p) {
      const double u = (p - half.from).dot(half.along);
      const double w = (p - half.from).dot(half.up);
      if (w > 0 && u > 0 && u < half.length) out.push_back({u, w, p});
    });
  }
}

bool same(const Flat& a, const Flat& b) { return a.u == b.u && a.w == b.w; }

// The chain's legs, those known to be free marked as before. Nothing where a blocked leg is left,
// which no more points will change.
std::optional<std::vector<Leg>> legs_of(const std::vector<Flat>& chain,
                                        const std::vector<Leg>& before) {
  std::vector<Leg> legs = {{chain.front(), true}};
  std::size_t k = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    while (k < before.size() && before[k].end.u < chain[i].u) ++k;
    const bool old = k > 0 && k < before.size() && same(before[k].end, chain[i]) &&
                     same(before[k - 1].end, chain[i - 1]);
    if (old && !before[k].free) return std::nullopt;
    legs.push_back({chain[i], old});
  }
  return legs;
}

// Finds out which legs are free. Returns points of what blocks the others.
std::vector<Flat> around_blocked(const geom::CollisionScene& scene, const HalfPlane& half,
                                 std::vector<Leg>& legs) {
  std::vector<Flat> points;
  for (std::size_t i = 1; i < legs.size(); ++i) {
    if (legs[i].free) continue;
    const auto boxes = scene.blockers(legs[i - 1].end.point, legs[i].end.point);
    legs[i].free = boxes.empty();
    add_points(scene, half, boxes, points);
  }
  return points;
}

bool all_free(const std::vector<Leg>& legs) {
  return std::all_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.free; });
}

bool inside(const geom::CollisionScene& scene, const std::vector<Leg>& legs) {
  return std::all_of(legs.begin(), legs.end(),
                     [&](const Leg& leg) { return scene.inside_bounds(leg.end.point); });
}

double length(const std::vector<Leg>& legs) {
  double sum = 0;
  for (std::size_t i = 1; i < legs.size(); ++i) {
    sum += (legs[i].end.point - legs[i - 1].end.point).norm();
  }
  return sum;
}

geom::Polyline path_of(const std::vector<Leg>& legs) {
  geom::Polyline path;
  for (const Leg& leg : legs) path.push_back(leg.end.point);
  return path;
}

}  // namespace

HalfPlane::HalfPlane(const Vec3& a, const Vec3& b, const Vec3& to_side)
    : from(a),
      to(b),
      along((b - a).normalized()),
      up(to_side),
      normal(along.cross(up)),
      length((b - a).norm()) {}

// The chain only grows, so it is given up once it is too long.
geom::Polyline chain_in(const geom::CollisionScene& scene, const HalfPlane& half, double than) {
  const Flat first{0, 0, half.from};
  const Flat last{half.length, 0, half.to};
  std::vector<Leg> legs = {{first, true}, {last, false}};
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Flat> points = around_blocked(scene, half, legs);
    if (all_free(legs)) return path_of(legs);
    for (std::size_t i = 1; i + 1 < legs.size(); ++i) points.push_back(legs[i].end);
    auto next = legs_of(upper_chain(std::move(points), first, last), legs);
    if (!next || !inside(scene, *next) || length(*next) >= than) return {};
    legs = std::move(*next);
  }
  return {};
}

}  // namespace plan
