#pragma once

// A ring with fewer corners that still keeps between what lies inside and outside of it.

#include <cstdint>
#include <vector>

#include "plan_shape.h"

namespace traj {

// Shapes that rings must not sweep over, found by place.
class Kept {
 public:
  Kept(std::vector<Outline> shapes, const PlanBox& bounds);

  // Whether none of the shapes reaches into the triangle by more than a micrometre.
  bool clear(const Vec2& a, const Vec2& b, const Vec2& c) const;
  bool within_bounds(const Vec2& p) const;

 private:
  struct Range {
    int from[2];
    int to[2];
  };
  Range range_of(const PlanBox& box) const;

  std::vector<Outline> shapes_;
  std::vector<PlanBox> boxes_;
  PlanBox bounds_;
  Vec2 step_;
  std::vector<std::vector<std::size_t>> buckets_;
};

// The simple ring, with corners taken out, and two next to each other put into one, as long as what
// the ring sweeps over meanwhile is clear, so that what lay inside stays inside. `seed` changes in
// which order, and so how many are left; 0: least areas first. At least three are left.
std::vector<Vec2> few_corners(const std::vector<Vec2>& ring, const Kept& kept, std::uint64_t seed);

// Whether edges that have no corner in common are a millimetre apart or more, and no corner is so
// near to the edges beside its own.
bool is_apart(const std::vector<Vec2>& ring);

}  // namespace traj
