#include "plan_shape.h"

#include <algorithm>

#include "traj/home/prism.h"

namespace traj {
namespace {

struct Interval {
  double low;
  double high;
};

Interval along(const Outline& outline, const Vec2& axis) {
  Interval out{axis.dot(outline.front()), axis.dot(outline.front())};
  for (const Vec2& p : outline) {
    const double at = axis.dot(p);
    out = {std::min(out.low, at), std::max(out.high, at)};
  }
  return out;
}

bool apart(const Outline& a, const Outline& b, const Vec2& axis, double depth) {
  const Interval of_a = along(a, axis);
  const Interval of_b = along(b, axis);
  return of_a.high - depth <= of_b.low || of_b.high - depth <= of_a.low;
}

// Whether the normal of a side of `of` separates the two.
bool apart_by_side(const Outline& of, const Outline& a, const Outline& b, double depth) {
  for (std::size_t i = 0; of.size() > 1 && i < of.size(); ++i) {
    const Vec2 side = of[(i + 1) % of.size()] - of[i];
    const double length = side.norm();
    if (length == 0) continue;
    if (apart(a, b, Vec2(side.y(), -side.x()) / length, depth)) return true;
  }
  return false;
}

}  // namespace

PlanBox box_around(const Outline& outline) {
  PlanBox box{outline.front(), outline.front()};
  for (const Vec2& p : outline) box = {box.min.cwiseMin(p), box.max.cwiseMax(p)};
  return box;
}

PlanBox grown(const PlanBox& box, double by) {
  return {box.min - Vec2::Constant(by), box.max + Vec2::Constant(by)};
}

bool overlap(const PlanBox& a, const PlanBox& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

Outline outline_of(const PlanBox& box) {
  return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

Outline outline_around(std::span<const Vec3> hull, const Vec2& room) {
  Outline points;
  for (const Vec3& p : hull) {
    const Vec2 at = p.head<2>();
    for (const Vec2& corner : outline_of({at - room, at + room})) points.push_back(corner);
  }
  return plan_hull(std::move(points));
}

Outline grown(const Outline& outline, double by) {
  Outline points;
  for (const Vec2& p : outline) {
    for (const Vec2& corner : outline_of(grown(PlanBox{p, p}, by))) points.push_back(corner);
  }
  return plan_hull(std::move(points));
}

bool meet(const Outline& a, const Outline& b, double depth) {
  if (apart(a, b, Vec2::UnitX(), depth) || apart(a, b, Vec2::UnitY(), depth)) return false;
  return !apart_by_side(a, a, b, depth) && !apart_by_side(b, a, b, depth);
}

bool holds(const Outline& outer, const Outline& inner) {
  if (outer.size() < 3) return false;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Vec2& a = outer[i];
    const Vec2 side = outer[(i + 1) % outer.size()] - a;
    for (const Vec2& p : inner) {
      if (cross(side, p - a) < 0) return false;
    }
  }
  return true;
}

}  // namespace traj
