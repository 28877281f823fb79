#pragma once

// Two flights whose nearest approach is known by construction, in exact numbers.

#include <array>
#include <cmath>
#include <utility>

#include "support/random_city.h"
#include "support/touch_case.h"
#include "traj/curve/trajectory.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace support {

using geom::Vec3;

// Control points lie on grids fine and small enough that each double below is exact.
struct PairCase {
  traj::Trajectory a;
  traj::Trajectory b;
  double start_a = 0;
  double start_b = 0;
  traj::Zone zone;
  traj::Parked parked = traj::Parked::gone;

  traj::TimedFlight first() const { return {&a, start_a, Vec3::Zero()}; }
  traj::TimedFlight second() const { return {&b, start_b, Vec3::Zero()}; }
};

// A zone, and the length of a step for `depth`: along `normal` (in plan) a step is exact.
struct ZoneCase {
  traj::Zone zone;
  Vec3 normal = Vec3::Zero();  // in plan, whole numbers of length `length`
  double length = 1;
  double across = 1;  // the surface is `across` times `normal` from zero
};

// Half sizes or radii such that points of the surface are exact.
inline ZoneCase random_zone(Random& random) {
  static constexpr std::array<std::array<double, 3>, 4> kTriples{
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 1, 1}}};
  ZoneCase c;
  const double up = random.stepped(0.5, 8, 0.125);
  if (random.below(2)) {
    const auto& [x, y, length] = kTriples[static_cast<std::size_t>(random.below(4))];
    c.normal = {random.below(2) ? x : -x, random.below(2) ? y : -y, 0};
    if (random.below(2)) std::swap(c.normal.x(), c.normal.y());
    c.length = length;
    c.across = random.stepped(0.125, 2, 0.125);
    c.zone = traj::cylinder(c.across * length, up);
    return c;
  }
  const int axis = random.below(2);
  c.normal[axis] = random.below(2) ? 1 : -1;
  c.across = random.stepped(0.5, 8, 0.125);
  c.zone = {false, {random.stepped(0.5, 8, 0.125), random.stepped(0.5, 8, 0.125), up}};
  c.zone.reach[axis] = c.across;
  return c;
}

inline double on_grid(double x) { return std::floor(x * 1024) / 1024; }

inline traj::Segment random_segment(Random& random, double duration) {
  traj::Segment s;
  s.duration = duration;
  const Vec3 from(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60));
  for (Vec3& p : s.point) {
    for (int i = 0; i < 3; ++i) p[i] = on_grid(from[i] + random.uniform(-20, 20));
  }
  return s;
}

// In plan well inside of the zone.
inline Vec3 inner(Random& random, const traj::Zone& zone) {
  const double x = zone.reach.x();
  const double y = zone.reach.y();
  return {on_grid(random.uniform(-0.5 * x, 0.5 * x)), on_grid(random.uniform(-0.5 * y, 0.5 * y)),
          on_grid(random.uniform(-0.5, 0.5) * zone.reach.z())};
}

using Seen = std::array<Vec3, traj::kPoints>;  // one flight from the other

// Comes down to `depth` above the lower end of the zone's upper face at its middle, and rises.
inline Seen over(Random& random, const ZoneCase& c, double depth) {
  traj::Segment s{1, {}, {}};
  double height = 0;
  for (int i = traj::kPoints / 2 - 1; i >= 0; --i) {
    height += random.stepped(0.25, 4, 0.25);
    const Vec3 p = inner(random, c.zone);
    const Vec3 q = inner(random, c.zone);
    s.point[i] = {p.x(), p.y(), height};
    s.point[traj::kDegree - i] = {q.x(), q.y(), height};
  }
  const double shift = c.zone.reach.z() - depth - point_at(s, 4).z();
  const bool below = random.below(2);
  for (Vec3& p : s.point) p.z() = below ? -(p.z() + shift) : p.z() + shift;
  return s.point;
}

// Along a straight line past the side of the zone, nearest in its middle: `steps` of c.length
// inside of the surface.
inline Seen past(Random& random, const ZoneCase& c, double steps) {
  const Vec3 middle = (c.across - steps) * c.normal + Vec3(0, 0, inner(random, c.zone).z());
  const Vec3 along(-c.normal.y(), c.normal.x(), random.stepped(-0.5, 0.5, 0.25));
  Seen q;
  for (int i = 0; i < traj::kPoints / 2; ++i) {
    const Vec3 way = random.stepped(0.25, 4, 0.25) * along;
    q[i] = middle - way;
    q[traj::kDegree - i] = middle + way;
  }
  return q;
}

// Straight away from the surface of the zone, whose `steps` it begins inside of.
inline Seen away(Random& random, const ZoneCase& c, double steps) {
  const bool up = random.below(3) == 0;
  const Vec3 out = up ? Vec3(0, 0, random.below(2) ? 1 : -1) : c.normal;
  const double across = (up ? c.zone.reach.z() : c.across) - steps;
  Vec3 beside = Vec3::Zero();
  if (up) beside.head<2>() = inner(random, c.zone).head<2>();
  if (!up) beside.z() = inner(random, c.zone).z();
  Seen q;
  double way = 0;
  for (Vec3& p : q) {
    p = beside + (across + way) * out;
    way += random.stepped(0, 4, 0.25);
  }
  return q;
}

inline Seen reversed(const Seen& q) {
  Seen out;
  for (std::size_t i = 0; i < q.size(); ++i) out[i] = q[q.size() - 1 - i];
  return out;
}

// The other flight: what is seen of it less than the first.
inline traj::Segment other_of(const traj::Segment& s, const Seen& seen) {
  traj::Segment out = s;
  for (std::size_t i = 0; i < seen.size(); ++i) out.point[i] = s.point[i] - seen[i];
  return out;
}

// Both halves as segments: exact for points on these grids.
inline void cut_in_two(traj::Trajectory& t, std::size_t at) {
  traj::Segment left = t.segments[at];
  traj::Segment right = left;
  auto q = left.point;
  for (std::size_t m = 0; m < q.size(); ++m) {
    left.point[m] = q[0];
    right.point[q.size() - 1 - m] = q[q.size() - 1 - m];
    for (std::size_t i = 0; i + 1 + m < q.size(); ++i) q[i] = (q[i] + q[i + 1]) / 2;
  }
  left.duration = right.duration = left.duration / 2;
  t.segments[at] = left;
  t.segments.insert(t.segments.begin() + static_cast<std::ptrdiff_t>(at) + 1, right);
}

enum class Meeting { over, past, joint, arrival, departure, rest };
inline constexpr int kMeetings = 6;

// Two flights that come to `steps` (of ZoneCase) inside of the surface of the zone, once and no
// deeper; < 0: beyond it. A multiple of 2^-31, at most 1/16 of a radius.
inline PairCase meeting(Random& random, Meeting how, double steps) {
  const ZoneCase zone = random_zone(random);
  PairCase c;
  c.zone = zone.zone;
  c.start_a = c.start_b = random.stepped(-86400, 86400, 0.125);
  const double time = random.stepped(0.5, 8, 0.5);
  const traj::Segment s = random_segment(random, time);
  c.a.segments = {s};
  if (how == Meeting::over || how == Meeting::past) {
    const Seen seen = how == Meeting::over ? over(random, zone, steps) : past(random, zone, steps);
    c.b.segments = {other_of(s, seen)};
    if (random.below(2)) cut_in_two(c.a, 0);
    if (random.below(2)) cut_in_two(c.b, 0);
  } else if (how == Meeting::departure) {
    traj::Segment later = random_segment(random, random.stepped(0.5, 8, 0.5));
    later.point[0] = s.point.back();
    c.a.segments.push_back(later);
    c.b.segments = {other_of(later, away(random, zone, steps))};
    c.start_b = c.start_a + time;
  } else {
    const Seen seen = away(random, zone, steps);
    c.b.segments = {other_of(s, reversed(seen))};
    if (how == Meeting::joint) {
      traj::Segment later = s;
      later.point = reversed(s.point);
      c.a.segments.push_back(later);
      c.b.segments.push_back(other_of(later, seen));
      if (random.below(2)) cut_in_two(c.b, 0);
    }
    if (how == Meeting::rest) c.parked = traj::Parked::pad;
  }
  if (random.below(2)) {
    std::swap(c.a, c.b);
    std::swap(c.start_a, c.start_b);
  }
  return c;
}

}  // namespace support
