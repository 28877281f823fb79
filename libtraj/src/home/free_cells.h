#pragma once

// The plan cut into cells by boxes, and rings around the cells that regions meet.

#include <optional>
#include <span>
#include <vector>

#include "plan_shape.h"

namespace traj {

// An area with holes: counterclockwise around, clockwise around each hole.
struct AreaRings {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

// One area within `bounds` that holds all of `inside` and none of the `outside` boxes, which must
// be apart from each other: cells between the sides of boxes. Each hole has a box in it. Nothing
// where regions are apart and no cells without a box join them, and beyond a hundred million cells.
std::optional<AreaRings> rings_between(std::span<const Outline> inside,
                                       std::span<const PlanBox> outside, const PlanBox& bounds);

}  // namespace traj
