#pragma once

// Small scenes and seeded random curves for the tests of libtraj.

#include <random>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "support/small_map.h"
#include "traj/curve/trajectory.h"

namespace traj::testing {

// The boxes as they stand: a vehicle without size.
inline geom::CollisionScene scene_of(const std::vector<geom::Aabb>& boxes,
                                     const geom::Aabb& bounds = {Vec3(-100, -100, 0),
                                                                 Vec3(300, 300, 100)}) {
  return {support::map_of(bounds, boxes), {"point", Vec3::Zero()}, 0};
}

inline geom::BoxMap one_box(const geom::Aabb& box = {{-1, -1, -1}, {1, 1, 1}}) {
  return support::map_of({{-50, -50, -50}, {50, 50, 50}}, {box});
}

inline State rest(const Vec3& p) { return {p}; }

// At constant speed.
inline Trajectory straight(const Vec3& from, const Vec3& to, double seconds = 10) {
  Segment s{seconds, {}, {}};
  for (std::size_t i = 0; i < s.point.size(); ++i) {
    s.point[i] = from + (to - from) * (static_cast<double>(i) / kDegree);
  }
  return {{s}};
}

// A curve that bends around, with a state at its middle.
inline Trajectory arc(const Vec3& middle, const Vec3& velocity) {
  const State through{middle, velocity, {0, 0, 1}, Vec3::Zero()};
  return {{hermite(rest(middle + Vec3(-12, 3, 2)), through, 4),
           hermite(through, rest(middle + Vec3(13, -2, 5)), 4)}};
}

struct Random {
  explicit Random(unsigned seed) : engine(seed) {}
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec3 vector(double size) {
    const double x = number(-size, size);
    const double y = number(-size, size);
    const double z = number(-size, size);
    return {x, y, z};
  }
  State state(double size) { return {vector(size), vector(size), vector(size), vector(size)}; }
  Segment segment() { return hermite(state(10), state(10), number(0.5, 3)); }
  std::mt19937_64 engine;
};

// From rest, in that many segments, to rest.
inline Trajectory random_trajectory(unsigned seed, int count = 5) {
  Random random(seed);
  Trajectory t;
  State state;
  for (int i = 0; i < count; ++i) {
    const State next = i + 1 == count ? State{random.vector(10)} : random.state(8);
    t.segments.push_back(hermite(state, next, random.number(0.5, 3)));
    state = next;
  }
  return t;
}

}  // namespace traj::testing
