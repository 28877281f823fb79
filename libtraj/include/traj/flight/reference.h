#pragma once

// Where a trajectory wants the vehicle to be at each instant, in ENU axes.
//
// Example:
//   const traj::ReferenceTrack track(trajectory);
//   std::size_t cursor = 0;
//   for (double t = 0; t < track.duration(); t += 0.01) {
//     const traj::Reference wanted = track.at(t, cursor);
//   }

#include <vector>

#include "traj/curve/trajectory.h"

namespace traj {

struct Reference {
  Vec3 position = Vec3::Zero();      // m
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 acceleration = Vec3::Zero();  // m/s2
  Vec3 jerk = Vec3::Zero();          // m/s3
  double yaw = 0;                    // rad from east
  double yaw_rate = 0;               // rad/s
};

// A trajectory made ready to be asked often. Immutable: threads may share it.
class ReferenceTrack {
 public:
  // Of a trajectory in ENU axes with at least one segment. Yaw is 0 where it has none.
  explicit ReferenceTrack(const Trajectory& trajectory);

  double duration() const { return duration_; }

  // At `t` seconds: before the start it hovers there, after the end likewise. `cursor` is where the
  // time before was found (start with 0); times that grow cost O(1).
  Reference at(double t, std::size_t& cursor) const;

 private:
  struct Piece {
    double begin;
    double duration;
    std::array<Vec3, 8> position;
    std::array<Vec3, 7> velocity;
    std::array<Vec3, 6> acceleration;
    std::array<Vec3, 5> jerk;
    std::array<double, 8> yaw;
    std::array<double, 7> yaw_rate;
  };
  std::vector<Piece> pieces_;
  double duration_ = 0;
};

}  // namespace traj
