#include "shadows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plan {
namespace {

using geom::Aabb;

constexpr double kAround = 32;       // metres: boxes farther away hide little
constexpr std::size_t kBoxes = 400;  // with more around the eye, a look at each costs too much
constexpr double kSpare = 1e-6;      // metres that boxes are taken to be smaller

// Where a direction meets the square |x| + |y| = 1, counted around it: [0, 4).
double around(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  const double part = y / sum;
  if (x >= 0) return y >= 0 ? part : 4 + part;
  return 2 - part;
}

struct Direction {  // on the square
  double x;
  double y;
};

// The inverse of around().
Direction direction(double place) {
  if (place >= 3) return {place - 3, place - 4};
  if (place >= 2) return {place - 3, 2 - place};
  if (place >= 1) return {1 - place, 2 - place};
  return {1 - place, place};
}

// The part of a ray from the origin inside a rectangle; empty where first > last.
struct Inside {
  double first;
  double last;
};

Inside inside(const Direction& d, const Aabb& box) {
  Inside in{0, std::numeric_limits<double>::infinity()};
  const double ways[] = {d.x, d.y};
  for (int k = 0; k < 2; ++k) {
    if (ways[k] == 0) {
      if (box.min[k] > 0 || box.max[k] < 0) return {1, 0};
      continue;
    }
    const double a = box.min[k] / ways[k];
    const double b = box.max[k] / ways[k];
    in.first = std::max(in.first, std::min(a, b));
    in.last = std::min(in.last, std::max(a, b));
  }
  return in;
}

// Which places around the origin a rectangle beside it takes up, unwrapped: first <= last.
struct Span {
  double first;
  double last;
};

Span span_of(const Aabb& box) {
  const Vec3 middle = 0.5 * (box.min + box.max);
  const double at = around(middle.x(), middle.y());
  Span span{at, at};
  for (int corner = 0; corner < 4; ++corner) {
    const double place =
        around(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y());
    const double off = place - at > 2    ? place - at - 4
                       : place - at < -2 ? place - at + 4
                                         : place - at;
    span.first = std::min(span.first, at + off);
    span.last = std::max(span.last, at + off);
  }
  return span;
}

bool beside(const Aabb& box) {
  return box.min.x() > 0 || box.max.x() < 0 || box.min.y() > 0 || box.max.y() < 0;
}

}  // namespace

Shadows::Shadows(const geom::CollisionScene& scene, const Vec3& eye) : eye_(eye) {
  Vec3 reach(kAround, kAround, 0);
  Aabb region{eye - reach, eye + reach};
  region.min.z() = scene.map().spec().bounds.min.z();
  region.max.z() = scene.map().spec().bounds.max.z();
  const auto near = scene.boxes_meeting(region, kBoxes);
  if (!near) return;
  for (const std::size_t i : *near) add(scene.grown(i));
}

// Seen from the eye, a box hides a sector where it holds a piece of the square around the eye from
// one side of the sector to the other: the box is convex.
void Shadows::add(const Aabb& grown) {
  const Vec3 spare = Vec3::Constant(kSpare);
  const Aabb box{grown.min - eye_ + spare, grown.max - eye_ - spare};
  if (!(box.min.array() < box.max.array()).all() || !beside(box)) return;
  constexpr double kOfPlace = kSectors / 4;
  const Span span = span_of(box);
  const auto first = static_cast<std::ptrdiff_t>(std::ceil(span.first * kOfPlace));
  const auto last = static_cast<std::ptrdiff_t>(std::floor(span.last * kOfPlace));
  for (std::ptrdiff_t s = first; s < last; ++s) {
    add(static_cast<std::size_t>(s + static_cast<std::ptrdiff_t>(kSectors)) % kSectors, box);
  }
}

void Shadows::add(std::size_t sector, const Aabb& box) {
  constexpr double kPlace = 4.0 / kSectors;
  const Inside a = inside(direction(static_cast<double>(sector) * kPlace), box);
  const Inside b = inside(direction(static_cast<double>(sector + 1) * kPlace), box);
  const double at = std::max(a.first, b.first);
  if (!(at > kSpare) || at > std::min(a.last, b.last)) return;
  const Hidden added{at, box.min.z() / at, box.max.z() / at};
  Hidden& known = hidden_[sector];
  if (known.low <= added.high && added.low <= known.high) {
    known = {std::max(known.beyond, at), std::min(known.low, added.low),
             std::max(known.high, added.high)};
  } else if (added.high - added.low > known.high - known.low) {
    known = added;
  }
}

bool Shadows::hides(const Vec3& p) const {
  const Vec3 d = p - eye_;
  const double far = std::abs(d.x()) + std::abs(d.y());
  if (!(far > 0)) return false;
  const auto sector = static_cast<std::size_t>(around(d.x(), d.y()) * (kSectors / 4)) % kSectors;
  const Hidden& hidden = hidden_[sector];
  return far > hidden.beyond && d.z() >= hidden.low * far && d.z() <= hidden.high * far;
}

bool Shadows::hides(const Aabb& whole) const {
  const Aabb box{whole.min - eye_, whole.max - eye_};
  if (!beside(box)) return false;
  double near = 0;
  double far = 0;
  for (int k = 0; k < 2; ++k) {
    near += std::max({0.0, box.min[k], -box.max[k]});
    far += std::max(std::abs(box.min[k]), std::abs(box.max[k]));
  }
  const double low = box.min.z() / (box.min.z() < 0 ? near : far);
  const double high = box.max.z() / (box.max.z() > 0 ? near : far);
  constexpr double kOfPlace = kSectors / 4;
  const Span span = span_of(box);
  const auto first = static_cast<std::ptrdiff_t>(std::floor(span.first * kOfPlace));
  const auto last = static_cast<std::ptrdiff_t>(std::floor(span.last * kOfPlace));
  for (std::ptrdiff_t s = first; s <= last; ++s) {
    const Hidden& hidden =
        hidden_[static_cast<std::size_t>(s + static_cast<std::ptrdiff_t>(kSectors)) % kSectors];
    if (!(near > hidden.beyond && low >= hidden.low && high <= hidden.high)) return false;
  }
  return true;
}

}  // namespace plan
