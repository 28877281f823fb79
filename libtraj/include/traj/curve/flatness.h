#pragma once

// The attitude, thrust and body rates of a quadrotor, from its motion and heading.
//
// Example:
//   const traj::State resting;
//   const traj::FlatState flat = traj::flat_state(resting, {.yaw = 0});
//   assert(flat.attitude.isIdentity() && flat.thrust == geom::kGravity);
//
// They follow by differential flatness.

#include <Eigen/Geometry>

#include "geom/map/frame.h"
#include "traj/curve/to_enu.h"
#include "traj/curve/trajectory.h"
#include "traj/curve/yaw.h"

namespace traj {

// Body axes x forward, y left, z up. Matrices turn body vectors into ENU ones.
struct FlatState {
  Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();
  double thrust = 0;              // m/s2 along the body's z: thrust over mass, |a + g|
  Vec3 body_rate = Vec3::Zero();  // rad/s about the body's axes (p, q, r)
};

// The attitude whose z axis is along `force` (not zero) and whose x axis has the heading `yaw` seen
// from above (Faessler, Franchi and Scaramuzza 2018, equations 20 to 22 without drag). Tilted by
// more than a right angle the body looks back over its heading, so that attitudes go on smoothly;
// PX4 agrees up to there and then turns the nose to the front. Where the force
// points to the left or right of the heading in the plane of the ground, no x axis has it: it is
// along the heading on the ground then.
Eigen::Matrix3d attitude_along(const Vec3& force, double yaw);

// The body rates (rad/s) of attitude_along() for a force over mass (m/s2, not zero) that changes by
// `jerk` (m/s3) while the heading turns: by differentiating the axes, exact. Without an x axis of
// the heading, the rate about z is 0.
Vec3 body_rates_along(const Vec3& force, const Vec3& jerk, const Heading& heading);

// `state` and `heading` in ENU axes: the force is a + g. In free fall (|a + g| < 1e-9 m/s2) the
// body is upright and its rates are those of yaw alone.
FlatState flat_state(const State& state, const Heading& heading);

// The heading in ENU t seconds into a trajectory of a map with these axes, clamped to [0,
// duration]; at a joint that of the later segment. Every segment has a yaw (precondition; add_yaw
// gives one). O(number of segments).
Heading heading_at(const Trajectory& trajectory, geom::Axes axes, double t);

}  // namespace traj
