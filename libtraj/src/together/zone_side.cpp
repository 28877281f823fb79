#include "zone_side.h"

#include <algorithm>
#include <cmath>

namespace traj {
namespace {

using Vec2 = Eigen::Vector2d;

// `off` bounds the rounding of what is worked out here, too: it is 340 times 2^-53 of the largest
// coordinate (timeline.h), of which the points themselves use 258.
bool beyond_side(const Points<kPoints>& q, int axis, double reach) {
  const auto over = [&](const Vec3& p) { return p[axis] > reach; };
  const auto under = [&](const Vec3& p) { return p[axis] < -reach; };
  return std::all_of(q.begin(), q.end(), over) || std::all_of(q.begin(), q.end(), under);
}

// All n . p > radius |n| + off (|n.x| + |n.y|).
bool beyond_upright(const Points<kPoints>& q, const Vec2& n, double radius, double off) {
  const double least = (radius * std::hypot(n.x(), n.y()) + off * n.lpNorm<1>()) * (1 + 0x1p-49);
  if (!(least > 0)) return false;
  return std::all_of(q.begin(), q.end(),
                     [&](const Vec3& p) { return n.x() * p.x() + n.y() * p.y() > least; });
}

// The least distance of an interval from zero.
double from_zero(double low, double high) { return std::max({low, -high, 0.0}); }

}  // namespace

Eigen::Vector2d nearest_direction(const Points<kPoints>& q) {
  const Vec2 from = q.front().head<2>();
  const Vec2 way = q.back().head<2>() - from;
  const double square = way.squaredNorm();
  if (!(square > 0)) return from;
  return from + std::clamp(-from.dot(way) / square, 0.0, 1.0) * way;
}

bool beyond(const Zone& zone, const Points<kPoints>& q, double off) {
  if (beyond_side(q, 2, zone.reach.z() + off)) return true;
  if (beyond_side(q, 0, zone.reach.x() + off)) return true;
  if (beyond_side(q, 1, zone.reach.y() + off)) return true;
  return zone.round && beyond_upright(q, nearest_direction(q), zone.reach.x(), off);
}

bool within(const Zone& zone, const Vec3& p, double off) {
  const Vec3 most = (p.cwiseAbs().array() + off) * (1 + 0x1p-49);
  if (!(most.z() <= zone.reach.z())) return false;
  if (!zone.round) return most.x() <= zone.reach.x() && most.y() <= zone.reach.y();
  return most.x() * most.x() + most.y() * most.y() <=
         zone.reach.x() * zone.reach.x() * (1 - 0x1p-49);
}

double least_share(const Zone& zone, const geom::Aabb& box) {
  const Vec3 least(from_zero(box.min.x(), box.max.x()), from_zero(box.min.y(), box.max.y()),
                   from_zero(box.min.z(), box.max.z()));
  return share_of(zone, least);
}

}  // namespace traj
