#pragma once

// Poses of SDF, joined without losing what is exact: sums of translations, and turns by quarters.

#include <array>

#include "geom/shape/aabb.h"
#include "sdf_node.h"
#include "shape/exact_sum.h"

namespace geom {

// x -> turn x + shift. Where both errors are 0, turn is a signed permutation and all is exact.
struct SdfPose {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  std::array<ExactSum, 3> shift;
  double turn_error = 0;   // of the matrix, as an operator
  double shift_error = 0;  // metres

  bool exact() const { return turn_error == 0 && shift_error == 0; }
  Vec3 place() const;  // the shift, rounded
};

// First `inner`, then `outer`; and what takes a pose back.
SdfPose operator*(const SdfPose& outer, const SdfPose& inner);
SdfPose inverse(const SdfPose& pose);

// What a <pose> says, whatever it is relative to: "x y z roll pitch yaw" in metres and radians (or
// degrees), "x y z qx qy qz qw", or nothing, which is no move. Refuses all else.
SdfPose parse_sdf_pose(const SdfNode& pose);

// The box of these half sizes about the pose's origin, along its axes. Precondition: the pose is
// exact. Rounded outward once.
Aabb placed_box(const SdfPose& pose, const Vec3& half);

// Refuses, at the element `at`, a pose that may be off by more than a hundredth of `slack` for
// points of a body that reaches `reach` metres from its origin.
void require_known_place(const SdfPose& pose, double reach, double slack, const SdfNode& at);

// A box that is turned already moved by the pose's shift, grown by what the errors may move the
// points of a body that reaches `reach` metres from its origin.
Aabb shifted(const SdfPose& pose, const Aabb& turned, double reach);

}  // namespace geom
