#pragma once

// Axis-aligned boxes: the one obstacle shape the rest of the toolkit sees.
//
// Example:
//   const geom::Aabb house{{0, 0, 0}, {10, 10, 8}};
//   assert(geom::distance({13, 5, 12}, house) == 5);
//   assert(geom::contains(house, {10, 5, 8}));                  // closed: faces belong to it
//   assert(geom::segment_hits({-5, 5, 4}, {15, 5, 4}, house));  // exact
//   const geom::Aabb blocked = geom::grow(house, {0.2, 0.2, 0.1});  // by a vehicle's half sizes

#include <optional>
#include <span>

#include "geom/base/vec3.h"

namespace geom {

// A closed box. Regular value: copy freely. `min(i) <= max(i)` on every axis.
struct Aabb {
  Vec3 min;
  Vec3 max;

  friend bool operator==(const Aabb& a, const Aabb& b) { return a.min == b.min && a.max == b.max; }
};

// The shortest distance from `p` to `box`, in metres; 0 inside or on the face. NaN if a
// coordinate of `p` is NaN.
double distance(const Vec3& p, const Aabb& box);

// Whether the closed box holds `p`. Exact.
bool contains(const Aabb& box, const Vec3& p);

// Whether two closed boxes share a point. Exact; touching counts.
bool overlap(const Aabb& a, const Aabb& b);

// Whether the closed segment from `a` to `b` meets the closed box. Exact for the doubles given:
// the separating-axis test with filtered orientation predicates, which fall back on exact numbers.
// A zero-length segment is a point. Finite coordinates of any size are decided right; a segment
// with a NaN counts as meeting each box that its other coordinates do not keep it from.
bool segment_hits(const Vec3& a, const Vec3& b, const Aabb& box);

// A part of a segment from a to b: that from a + from (b - a) to a + to (b - a).
struct SegmentPart {
  double from = 0;
  double to = 1;
};

// The part of the segment from `a` to `b` in the closed box, 0 <= from <= to <= 1; nothing where
// there is none. Rounded: each end by a few ulp of 1, and a segment that comes within rounding of
// the box may be taken to miss it. Only segment_hits() decides what collides.
std::optional<SegmentPart> clip(const Vec3& a, const Vec3& b, const Aabb& box);

// The smallest box around two boxes, and around all of `points` or `boxes` (nothing when there are
// none).
Aabb merged(const Aabb& a, const Aabb& b);
std::optional<Aabb> bounds(std::span<const Vec3> points);
std::optional<Aabb> bounds(std::span<const Aabb> boxes);

// `obstacle` grown by a vehicle of half sizes `half` (metres, >= 0): where the vehicle's reference
// point collides. This is the only growth in the toolkit. It is rounded outward, and reaches
// max(5e-10 m, 2 ulp of the largest coordinate) beyond the real sum, so that whatever
// is within rounding of touching counts as touching.
Aabb grow(const Aabb& obstacle, const Vec3& half);

// Where the reference point of a vehicle of half sizes `half` may be while the whole vehicle is
// inside the closed `bounds`. Rounded inward; nothing for NaN, or if the vehicle does not fit.
std::optional<Aabb> shrink(const Aabb& bounds, const Vec3& half);

}  // namespace geom
