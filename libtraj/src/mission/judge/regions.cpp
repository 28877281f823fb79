#include "traj/mission/judge/regions.h"

#include <algorithm>

#include "geom/base/precondition.h"
#include "geom/shape/hull.h"
#include "proof/check_place.h"

namespace traj {
namespace {

using geom::Aabb;
using geom::Vec2;

Aabb padded(const Aabb& box, const Vec3& by) { return {box.min - by, box.max + by}; }

// A hair wider, for the rounding of what is added to boxes.
Vec3 sure(const Vec3& pad) { return pad * (1 + 1e-12) + Vec3::Constant(1e-9); }

// How far out of the closed bounds a point is, along the worst axis; <= 0 inside.
double way_out(const Aabb& bounds, const Vec3& p) {
  return std::max((bounds.min - p).maxCoeff(), (p - bounds.max).maxCoeff());
}

// The vehicle's box around each place, how far beside a sweep that place may be, and where the
// places must be so that the box is inside the bounds.
struct Room {
  Vec3 half;
  Vec3 pad;
  std::optional<Aabb> free;
};

Room planned_room(const geom::CollisionScene& scene, const Vec3& stray) {
  return {scene.half(), stray.isZero(0) ? Vec3(Vec3::Zero()) : sure(stray), scene.free_bounds()};
}

Room drift_room(const geom::CollisionScene& scene, const Vec3& around, const Vec3& navigation) {
  const Vec3 half = sure(scene.vehicle().half + navigation);
  return {half, sure(around), geom::shrink(scene.map().spec().bounds, half)};
}

// How far a place leaves the bounds, with what is beside it; <= 0: not at all.
double way_out(const Room& room, const Sweep& sweep, const Vec3& p) {
  if (!room.free) return room.half.maxCoeff();
  Aabb free = *room.free;
  if (sweep.stands_on) free.min.z() = -geom::kFarthest;  // it stands on the floor
  const Vec3 pad = room.pad.cwiseMax(1e-9);
  return std::max(way_out(free, p - pad), way_out(free, p + pad));
}

// The worst of the sweeps that leave the bounds.
std::optional<std::size_t> first_outside(const Room& room, std::span<const Sweep> sweeps,
                                         CheckResult& result) {
  std::optional<std::size_t> which;
  double worst = 0;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    for (const Vec3& p : sweeps[i].hull) {
      const double out = way_out(room, sweeps[i], p);
      if (!(out > worst)) continue;
      worst = out;
      which = i;
      note(result, Reason::bounds, {out, 0, p});
    }
  }
  return which;
}

std::optional<std::size_t> deepest(const geom::CollisionScene& scene, const Room& room,
                                   std::span<const Sweep> sweeps, CheckResult& result) {
  const Vec3 reach = room.pad + (room.half - scene.half()).cwiseMax(0);
  std::optional<std::size_t> which;
  geom::HullDepth worst{-1, Vec3::Zero()};
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const std::vector<Vec3>& hull = sweeps[i].hull;
    const auto near = scene.boxes_meeting(padded(*geom::bounds(hull), reach));
    result.looked_at += near.size();
    for (const std::size_t box : near) {
      const Aabb obstacle = scene.map().box(box);
      if (sweeps[i].stands_on && obstacle.max.z() <= *sweeps[i].stands_on) continue;
      const Aabb grown = padded(geom::grow(obstacle, room.half), room.pad);
      if (!geom::hull_meets(hull, grown)) continue;
      const geom::HullDepth depth = geom::hull_depth(hull, grown);
      if (depth.depth <= worst.depth) continue;
      worst = depth;
      which = i;
      result.box = box;
    }
  }
  if (which) note(result, Reason::collision, {worst.depth, 0, worst.place});
  return which;
}

// --- fences -----------------------------------------------------------------------------------

Vec3 flat(const Vec2& p) { return {p.x(), p.y(), 0}; }

// Whether the hull, seen from above and with the box `half` around each point, meets the edge: the
// hull of all differences then holds a point of that box.
bool meets_edge(std::span<const Vec3> hull, const Vec2& a, const Vec2& b, const Vec2& half) {
  std::vector<Vec3> differences;
  for (const Vec3& p : hull) {
    for (const Vec2& end : {a, b}) differences.push_back(flat(p.head<2>() - end));
  }
  return geom::hull_meets(differences, {flat(-half), flat(half)}).has_value();
}

// A point of an edge that the hull meets, by halving: for reports.
Vec2 point_met(std::span<const Vec3> hull, Vec2 a, Vec2 b, const Vec2& half) {
  for (int i = 0; i < 40; ++i) {
    const Vec2 middle = 0.5 * (a + b);
    (meets_edge(hull, a, middle, half) ? b : a) = middle;
  }
  return a;
}

// A fence, in questions about one region.
struct Ring {
  explicit Ring(const Fence& fence)
      : polygon{fence.ring, {}}, inclusion(fence.inclusion), bulge(fence.bulge) {}

  // Where the region does not keep to the fence; nothing where it does.
  std::optional<Vec2> breach(std::span<const Vec3> hull, const Vec2& half) const {
    const Vec2 around = half + Vec2::Constant(bulge);
    const Aabb box = *geom::bounds(hull);
    const Vec2 low = box.min.head<2>() - around;
    const Vec2 high = box.max.head<2>() + around;
    const std::vector<Vec2>& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      if ((a.cwiseMax(b).array() < low.array()).any()) continue;
      if ((a.cwiseMin(b).array() > high.array()).any()) continue;
      if (meets_edge(hull, a, b, around)) return point_met(hull, a, b, around);
    }
    const Vec2 first = hull.front().head<2>();
    if (geom::contains(polygon, first) == inclusion) return std::nullopt;
    return first;
  }

  // How far beyond the fence a point is.
  double beyond(const Vec3& p) const {
    const Vec2 at = p.head<2>();
    if (inclusion) return geom::distance(polygon, at);
    if (!geom::contains(polygon, at)) return 0;
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<Vec2>& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geom::Polygon edge{{ring[i], ring[(i + 1) % ring.size()]}, {}};
      nearest = std::min(nearest, geom::distance(edge, at));
    }
    return nearest;
  }

  geom::Polygon polygon;
  bool inclusion;
  double bulge;
};

void refused(const Sweep& sweep, CheckResult& result) {
  result.ok = false;
  result.part = sweep.part;
}

}  // namespace

void check_sweeps(const geom::CollisionScene& scene, std::span<const Sweep> sweeps,
                  const Vec3& stray, CheckResult& result) {
  if (result.reason != Reason::none || sweeps.empty()) return;
  const Room room = planned_room(scene, stray);
  auto which = first_outside(room, sweeps, result);
  if (!which) which = deepest(scene, room, sweeps, result);
  if (which) refused(sweeps[*which], result);
}

void check_drift(const geom::CollisionScene& scene, std::span<const Drift> drift, const Vec3& stray,
                 const Vec3& navigation, CheckResult& result) {
  for (const Drift& one : drift) {
    if (result.reason != Reason::none) return;
    const Room room = drift_room(scene, one.around + stray, navigation);
    auto which = first_outside(room, one.sweeps, result);
    if (!which) which = deepest(scene, room, one.sweeps, result);
    if (!which) continue;
    refused(one.sweeps[*which], result);
    result.strayed = one.autopilot;
  }
}

namespace {

void hold_fences(std::span<const Sweep> sweeps, std::span<const Fence> fences, const Vec2& half,
                 CheckResult& result) {
  if (result.reason != Reason::none) return;
  for (const Fence& fence : fences) {
    const Ring ring(fence);
    for (const Sweep& sweep : sweeps) {
      const auto at = ring.breach(sweep.hull, half);
      if (!at) continue;
      double beyond = 0;
      for (const Vec3& p : sweep.hull) beyond = std::max(beyond, ring.beyond(p));
      note(result, Reason::fence, {beyond, 0, {at->x(), at->y(), sweep.hull.front().z()}});
      return refused(sweep, result);
    }
  }
}

}  // namespace

void check_fences(const geom::CollisionScene& scene, std::span<const Sweep> sweeps,
                  std::span<const Fence> fences, const Vec3& stray, CheckResult& result) {
  hold_fences(sweeps, fences, (scene.half() + sure(stray)).head<2>(), result);
}

void check_fences(const geom::CollisionScene& scene, std::span<const Drift> drift,
                  std::span<const Fence> fences, const Vec3& stray, const Vec3& navigation,
                  CheckResult& result) {
  for (const Drift& one : drift) {
    if (result.reason != Reason::none) return;
    const Room room = drift_room(scene, one.around + stray, navigation);
    hold_fences(one.sweeps, fences, (room.half + room.pad).head<2>(), result);
    if (result.reason != Reason::none) result.strayed = one.autopilot;
  }
}

}  // namespace traj
