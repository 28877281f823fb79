#pragma once

// Flights at random places and of random shapes, and how near two of them come, by sampling.

#include <algorithm>

#include "fleet/forbidden_between.h"
#include "geom/base/random.h"
#include "traj/curve/trajectory.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace traj::testing {

inline Vec3 random_place(geom::SplitMix64& random, double across, double up) {
  return {random.uniform(-across, across), random.uniform(-across, across), random.uniform(0, up)};
}

// Joins of a few polynomials that meet with velocity and acceleration.
inline Trajectory random_flight(geom::SplitMix64& random, double across = 100, double up = 20) {
  const int segments = random.whole(1, 4);
  Trajectory out;
  State from;
  from.position = random_place(random, across, up);
  for (int i = 0; i < segments; ++i) {
    State to;
    to.position = random_place(random, across, up);
    if (i + 1 < segments) {
      to.velocity = random_place(random, 8, 2);
      to.acceleration = random_place(random, 1, 1);
    }
    out.segments.push_back(hermite(from, to, random.uniform(5, 30)));
    from = to;
  }
  return out;
}

// 20 s at one speed from one place to another, with no time to speed up.
inline Trajectory steady(const Vec3& from = {-100, 0, 0}, const Vec3& to = {100, 0, 0}) {
  const Vec3 v = (to - from) / 20;
  return {{hermite({from, v}, {to, v}, 20)}};
}

inline bool holds(const std::vector<DepartureSpan>& spans, double departure) {
  return std::ranges::any_of(spans, [&](const auto& span) { return span.holds(departure); });
}

// Of two flights that are not cut into pieces yet.
inline std::vector<DepartureSpan> forbidden_departures(const Trajectory& first,
                                                       const Trajectory& second,
                                                       std::span<const Zone> zones, Parked parked,
                                                       const DepartureSpan& window = {}) {
  const Bend bend = bend_for(zones);
  return forbidden_between(course_of(first, parked, bend), course_of(second, parked, bend), zones,
                           window);
}

// At `time` after departure, where it is there.
inline Vec3 place_at(const Trajectory& flight, double time) {
  return evaluate(flight, std::clamp(time, 0.0, duration(flight))).position;
}

// The least share_of() at any of many instants, the second departing `difference` later; infinite
// where they are never there at once.
inline double least_share(const Trajectory& a, const Trajectory& b, const Zone& zone, Parked parked,
                          double difference, int samples = 2000) {
  double begin = std::max(0.0, difference);
  double end = std::min(duration(a), difference + duration(b));
  if (parked == Parked::pad) {
    begin = std::min(0.0, difference) - 1;
    end = std::max(duration(a), difference + duration(b)) + 1;
  }
  double least = std::numeric_limits<double>::infinity();
  if (begin > end) return least;
  for (int i = 0; i <= samples; ++i) {
    const double t = begin + (end - begin) * i / samples;
    least = std::min(least, share_of(zone, place_at(a, t) - place_at(b, t - difference)));
  }
  return least;
}

}  // namespace traj::testing
