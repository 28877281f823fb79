#pragma once

// Differential flatness of a quadrotor: attitude, thrust and body rates that follow from where it
// is to be and where it is to look.

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

// `state` and `heading` in ENU axes. The body's z is along a + g, its x has the heading `yaw` seen
// from above (Faessler, Franchi and Scaramuzza 2018, equations 20 to 22 without drag; rates by
// differentiating the axes, exact). In free fall (|a + g| < 1e-9 m/s2) z is up and the rates are
// those of yaw alone. Tilted by more than a right angle the body looks back over its heading;
// thrust must not point to the left or right of the heading in the plane of the ground
// (precondition), where x is not defined.
FlatState flat_state(const State& state, const Heading& heading);

// The heading in ENU t seconds into a trajectory of a map with these axes, clamped to [0,
// duration]; at a joint that of the later segment. Every segment has a yaw (precondition; add_yaw
// gives one). O(number of segments).
Heading heading_at(const Trajectory& trajectory, geom::Axes axes, double t);

}  // namespace traj
