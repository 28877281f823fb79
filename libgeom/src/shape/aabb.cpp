#include "geom/shape/aabb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geom/base/rounding.h"
#include "orientation.h"

namespace geom {
namespace {

// How far grow() reaches beyond the real sum.
double growth_slack(double coordinate) { return std::max(5e-10, 2 * ulp(coordinate)); }

// A side of a box, further out by `half` and the slack. The low side counts downward, from -min.
double grown_side(double side, double half) {
  const double sum = add_up(side, half);
  return add_up(sum, growth_slack(sum));
}

// The same of two sides at once and without calls, since queries grow every candidate. Up to this
// coordinate, 2 ulp are less than 5e-10.
constexpr double kSteadySlack = 0x1p21;
using Two = double __attribute__((vector_size(16)));
using TwoWords = std::int64_t __attribute__((vector_size(16)));

// add_up. The next double is one further in the order of bits, which counts away from 0; where the
// sum is 0 it is exact.
Two sum_up(Two a, Two b) {
  const Two sum = a + b;
  const Two b_part = sum - a;
  const Two error = (a - (sum - b_part)) + (b - b_part);
  const TwoWords outward = (sum < 0.0) | 1;
  return std::bit_cast<Two>(std::bit_cast<TwoWords>(sum) + ((error > 0.0) & outward));
}

// orientation(), inline: a segment asks it of most boxes that it comes near.
inline int oriented(double ax, double ay, double bx, double by, double cx, double cy) {
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  const double det = left - right;
  // Shewchuk 1997, ccwerrboundA = (3 + 16 eps) eps; the constant below covers underflow.
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right)) + 1e-290;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exact_orientation(ax, ay, bx, by, cx, cy);
}

// Whether the line through a and b (not one point) passes strictly beside the rectangle.
bool line_misses(double ax, double ay, double bx, double by, double lx, double ly, double hx,
                 double hy) {
  // The two corners furthest to each side depend on the signs of the direction only.
  const bool rising = (bx >= ax) == (by >= ay);
  const int one = oriented(ax, ay, bx, by, lx, rising ? hy : ly);
  if (one == 0) return false;
  return one == oriented(ax, ay, bx, by, hx, rising ? ly : hy);
}

// Where squares overflow; infinite only where the distance itself is beyond doubles.
double far_distance(const Vec3& p, const Aabb& box) {
  const auto off = [&](int i) { return std::max({box.min[i] - p[i], p[i] - box.max[i], 0.0}); };
  return std::hypot(std::hypot(off(0), off(1)), off(2));  // of three, it gives NaN of infinite ones
}

}  // namespace

int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
  return oriented(ax, ay, bx, by, cx, cy);
}

double distance(const Vec3& p, const Aabb& box) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = std::max({box.min[i] - p[i], p[i] - box.max[i], 0.0});
    sum += d * d;
  }
  if (std::isinf(sum)) return far_distance(p, box);
  return std::sqrt(sum);
}

bool contains(const Aabb& box, const Vec3& p) {
  return p[0] >= box.min[0] && p[0] <= box.max[0] && p[1] >= box.min[1] && p[1] <= box.max[1] &&
         p[2] >= box.min[2] && p[2] <= box.max[2];
}

bool overlap(const Aabb& a, const Aabb& b) {
  return a.min[0] <= b.max[0] && b.min[0] <= a.max[0] && a.min[1] <= b.max[1] &&
         b.min[1] <= a.max[1] && a.min[2] <= b.max[2] && b.min[2] <= a.max[2];
}

bool segment_hits(const Vec3& a, const Vec3& b, const Aabb& box) {
  for (int i = 0; i < 3; ++i) {
    // Both, one after the other: so that what is not a number is on neither side.
    if (a[i] < box.min[i] && b[i] < box.min[i]) return false;
    if (a[i] > box.max[i] && b[i] > box.max[i]) return false;
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    // Without extent along one axis the face normals above have already decided this plane.
    if (a[i] == b[i] || a[j] == b[j]) continue;
    if (line_misses(a[i], a[j], b[i], b[j], box.min[i], box.min[j], box.max[i], box.max[j])) {
      return false;
    }
  }
  return true;
}

Aabb merged(const Aabb& a, const Aabb& b) { return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)}; }

std::optional<Aabb> bounds(std::span<const Vec3> points) {
  if (points.empty()) return std::nullopt;
  Aabb box{points.front(), points.front()};
  for (const Vec3& p : points) box = merged(box, {p, p});
  return box;
}

std::optional<Aabb> bounds(std::span<const Aabb> boxes) {
  if (boxes.empty()) return std::nullopt;
  Aabb all = boxes.front();
  for (const Aabb& box : boxes) all = merged(all, box);
  return all;
}

std::optional<SegmentPart> clip(const Vec3& a, const Vec3& b, const Aabb& box) {
  const Vec3 d = b - a;
  SegmentPart inside{0, 1};
  for (int i = 0; i < 3; ++i) {
    if (std::max(a[i], b[i]) < box.min[i] || std::min(a[i], b[i]) > box.max[i]) return std::nullopt;
    if (d[i] == 0) continue;
    const double u = (box.min[i] - a[i]) / d[i];
    const double v = (box.max[i] - a[i]) / d[i];
    inside.from = std::max(inside.from, std::min(u, v));
    inside.to = std::min(inside.to, std::max(u, v));
  }
  if (inside.from > inside.to) return std::nullopt;
  return inside;
}

Aabb grow(const Aabb& obstacle, const Vec3& half) {
  Aabb grown;
  for (int i = 0; i < 3; ++i) {
    const Two sum = sum_up(Two{-obstacle.min[i], obstacle.max[i]}, Two{half[i], half[i]});
    const Two sides = sum_up(sum, Two{5e-10, 5e-10});
    grown.min[i] = -sides[0];
    grown.max[i] = sides[1];
    if (std::max(std::abs(sum[0]), std::abs(sum[1])) <= kSteadySlack) continue;
    grown.min[i] = -grown_side(-obstacle.min[i], half[i]);
    grown.max[i] = grown_side(obstacle.max[i], half[i]);
  }
  return grown;
}

std::optional<Aabb> shrink(const Aabb& bounds, const Vec3& half) {
  Aabb inner;
  for (int i = 0; i < 3; ++i) {
    inner.min[i] = add_up(bounds.min[i], half[i]);
    inner.max[i] = add_down(bounds.max[i], -half[i]);
    if (!(inner.min[i] <= inner.max[i])) return std::nullopt;  // NaN, too
  }
  return inner;
}

}  // namespace geom
