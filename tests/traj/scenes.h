#pragma once

// Small scenes and seeded random curves for the tests of libtraj.

#include <random>
#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/curve/trajectory.h"

namespace traj::testing {

// The boxes as they stand: a vehicle without size.
inline geom::CollisionScene scene_of(const std::vector<geom::Aabb>& boxes,
                                     const geom::Aabb& bounds = {Vec3(-100, -100, 0),
                                                                 Vec3(300, 300, 100)}) {
  geom::BoxTable table;
  table.boxes = boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    table.ids.push_back(i);
    table.label.push_back(0);
  }
  geom::BoxMapSpec spec;
  spec.bounds = bounds;
  spec.bounds_from = "option";
  return {geom::BoxMap(spec, table), geom::Vehicle{"point", Vec3::Zero()}, 0};
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
