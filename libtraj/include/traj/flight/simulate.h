#pragma once

// One flight along a trajectory: vehicle, controller, wind and sensors together.
//
// Example:
//   const auto tello = traj::vehicle_named("tello");
//   traj::FlightOptions options{.quadrotor = *traj::quadrotor_of(tello->airframe)};
//   options.gains = *tello->airframe.gains;
//   const traj::Flight flight = traj::simulate(traj::ReferenceTrack(trajectory), options, {});
//   assert(!flight.lost && flight.final_distance < 0.1);

#include <optional>
#include <vector>

#include "geom/text/words.h"
#include "traj/flight/controller.h"
#include "traj/flight/flight_log.h"
#include "traj/flight/reference.h"
#include "traj/flight/wind.h"

namespace traj {

inline constexpr double kStep = 1e-3;          // s, of the integrator and the rate loop
inline constexpr int kStepsPerSample = 10;     // errors are taken, and gusts change, every 10 ms
inline constexpr double kSamplePeriod = 0.01;  // s

enum class ControlLaw { cascade, geometric };
inline constexpr geom::Words<ControlLaw, 2> kControlLawWords{{
    {ControlLaw::cascade, "cascade"},
    {ControlLaw::geometric, "geometric"},
}};

struct FlightOptions {
  Quadrotor quadrotor;  // what the controller believes
  Gains gains;
  ControlLaw law = ControlLaw::cascade;
  LoopPeriods periods;
  // What is true of the vehicle is (1 + this) times what the controller believes; each > -1.
  double mass_error = 0;
  double drag_error = 0;
  double motor_lag_error = 0;
  Vec3 inertia_error = Vec3::Zero();  // about each axis
  WindSpec wind;
  SensorSpec sensors;
  std::uint64_t seed = 0;
  double hover = 3;   // s of hovering before the start
  double settle = 3;  // s of hovering after the end
};

// The vehicle as it is.
Quadrotor true_vehicle(const FlightOptions& options);

// What to keep of a flight beside its errors.
struct FlightKeep {
  int log_period = 0;  // ms between samples of the log, a multiple of 10; 0: none
  bool path = false;   // every position
};

// From the trajectory's start on; the hovering before is not told.
struct Flight {
  std::optional<double> lost;  // s: when the vehicle was out of control, which ends the flight
  std::vector<double> error;   // m, distance to the reference, at k * kSamplePeriod
  std::vector<double> tilt;    // rad, the largest since the sample before
  double velocity_error = 0;   // m/s, root mean square up to the trajectory's end
  double final_distance = 0;   // m from the last point, at the very end
  double fastest_air = 0;      // m/s, of the air past the vehicle
  double hover_seconds = 0;    // s of hovering that take the same energy
  double saturated = 0;        // share of the samples before which a command was clipped
  std::vector<FlightSample> samples;  // of the log
  std::vector<Vec3> path;             // every kStep
};

// Starts level and at rest (or with the trajectory's own first velocity where `hover` is 0) with
// the motors holding the weight. Power goes with thrust to the power 3/2 (momentum theory). Lost:
// more than 100 m from the reference, turning faster than 100 rad/s, or not finite. No allocation
// in the loop. Deterministic for a libm.
Flight simulate(const ReferenceTrack& track, const FlightOptions& options, const FlightKeep& keep);

}  // namespace traj
