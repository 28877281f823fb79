#pragma once

// What the controller gets to see: the state with noise, its position and velocity late.
//
// Example:
//   traj::QuadrotorState state;
//   traj::Sensors sensors({.position = 0.02}, state, 7);  // 2 cm of noise; the seed
//   const traj::Measured measured = sensors.read(state);

#include <vector>

#include "traj/flight/noise.h"
#include "traj/flight/quadrotor.h"

namespace traj {

// White, independent on each axis and each reading; standard deviations >= 0.
struct SensorSpec {
  double position = 0;  // m
  double velocity = 0;  // m/s
  double attitude = 0;  // rad
  double rates = 0;     // rad/s
  double delay = 0;     // s, of position and velocity: whole milliseconds
};

struct Measured {
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Vec3 body_rates = Vec3::Zero();
};

class Sensors {
 public:
  Sensors(const SensorSpec& spec, const QuadrotorState& start, std::uint64_t seed);

  // The reading at a millisecond; call once each.
  Measured read(const QuadrotorState& state);

 private:
  struct Fix {
    Vec3 position;
    Vec3 velocity;
  };
  SensorSpec spec_;
  Gaussian noise_;
  std::vector<Fix> late_;  // a ring of the last readings
  std::size_t at_ = 0;
};

}  // namespace traj
