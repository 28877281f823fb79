#pragma once

// A hash of a simulated vehicle. Results that hold for this vehicle alone name it.
//
// Example:
//   traj::FlightOptions options;
//   const std::string hash = traj::model_hash(options);
//   options.gains.attitude.x() += 1;
//   assert(traj::model_hash(options) != hash);

#include <string>

#include "traj/flight/simulate.h"

namespace traj {

// SHA-256, in hexadecimal, over what flies: the quadrotor that the controller believes, the
// controller with its gains, and the periods of its loops. Errors, winds and sensors do not count.
std::string model_hash(const FlightOptions& options);

}  // namespace traj
