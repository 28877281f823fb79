#pragma once

// How far the simulated vehicle can stray from its trajectory: proved, for stated disturbances.
//
// Example:
//   const auto quad = traj::vehicle_named("quad2kg");
//   traj::FlightOptions options{.quadrotor = *traj::quadrotor_of(quad->airframe)};
//   options.gains = *quad->airframe.gains;
//   options.law = traj::ControlLaw::geometric;
//   const traj::ProvedTube tube = traj::prove_tube(
//       traj::ReferenceTrack(trajectory), options, {.wind_spread = 0.2, .gust_most = 0.5}, {});
//   if (!tube.trouble) std::cout << "never further than " << tube.largest << " m\n";
//
// docs/tube.md states the model and derives the bounds.

#include <optional>
#include <vector>

#include "geom/base/execution.h"
#include "geom/text/words.h"
#include "traj/flight/simulate.h"

namespace traj {

// What may act on the vehicle, and in what it may differ from what its controller believes.
struct Disturbances {
  Vec3 wind = Vec3::Zero();  // m/s, of the air: the middle of the mean winds
  double wind_spread = 0;    // m/s, >= 0: the mean wind is within this of the middle, and constant
  double gust_most =
      0;  // m/s, >= 0: gusts g obey gust_lag g' = n - g, g = 0 at first, |n| <= gust_most
  double gust_lag = 1;  // s, > 0
  // When it begins to hover, the vehicle is level, and within these of where it should be and of
  // rest.
  double start_error = 0;  // m, >= 0
  double start_speed = 0;  // m/s, >= 0
  // The vehicle is within these shares of what is believed, each in [0, 0.5].
  double mass_error = 0;
  double drag_error = 0;
  double motor_lag_error = 0;  // of the motors' time constant
  double inertia_error = 0;    // about each axis by itself
  // Each gain of the controller (p, i and d of the cascade's loops) is within this share of what it
  // should be, axis by axis, and constant. In [0, 0.5].
  double gain_error = 0;
  // Each reading of the sensors is off by at most this along each axis, >= 0. The measured attitude
  // is the true one times a quaternion. Twice the vector part of that over its scalar part is
  // bounded.
  double place_noise = 0;     // m
  double velocity_noise = 0;  // m/s
  double attitude_noise = 0;  // rad, about the body's axes
  double rate_noise = 0;      // rad/s

  bool has_noise() const {
    return place_noise > 0 || velocity_noise > 0 || attitude_noise > 0 || rate_noise > 0;
  }
};

// Why nothing is proved. Under the cascade a command may be clipped: the velocity that the position
// loop wants, the acceleration that the velocity loop wants, the lift, its horizontal part by the
// largest tilt (lean), the rates that the attitude loop wants, or the angular acceleration that the
// rate loop wants (turn).
struct TubeTrouble {
  enum class Kind {
    motor,
    tilt,
    unstable,
    steps,
    velocity,
    acceleration,
    lift,
    lean,
    rates,
    turn
  } kind = Kind::motor;
  int motor = 0;    // 1 to 4: the command of this motor may leave its range,
  double time = 0;  // s, from the trajectory's start: then,
  double room = 0;  // N, m/s, m/s2, rad/s or rad/s2, <= 0: by as much as this
};

inline constexpr geom::Words<TubeTrouble::Kind, 10> kTubeTroubleWords{{
    {TubeTrouble::Kind::motor, "motor"},
    {TubeTrouble::Kind::tilt, "tilt"},
    {TubeTrouble::Kind::unstable, "unstable"},
    {TubeTrouble::Kind::steps, "steps"},  // a millisecond is too coarse for the vehicle
    {TubeTrouble::Kind::velocity, "velocity"},
    {TubeTrouble::Kind::acceleration, "acceleration"},
    {TubeTrouble::Kind::lift, "lift"},
    {TubeTrouble::Kind::lean, "lean"},
    {TubeTrouble::Kind::rates, "rates"},
    {TubeTrouble::Kind::turn, "turn"},
}};

// Periods of the attitude loop, one after the other, and bounds on how far the state is from the
// nominal flight of a cell in them, in the order of docs/tube.md. Geometric controller: lift,
// velocity, lag, heading, rates, spin, filtered, turned. Cascade: lift, velocity, tilt (x and y),
// missing, heading, rates, spin, filtered, integral, missed, slope, due. Last stands the
// acceleration that lift and drag give together (without drag: the gust).
struct SpanBounds {
  int periods = 0;
  std::vector<double> bounds;
};

// A part of the winds and masses, and the bounds that its proof used.
struct ProvedCell {
  // Empty: all. Each number says which part of the one before: bits 0 to 2 are set for the upper
  // half of the winds east, north and up, bit 3 for that of the masses.
  std::vector<int> part;
  std::vector<SpanBounds> spans;  // from the start of the hovering on; for a certificate
};

struct ProvedTube {
  std::vector<double> radius;  // m, in each kTubePeriod (as TrackingTube's); empty without a proof
  double largest = 0;          // m
  double tilt = 0;             // rad: it never tilts further
  std::size_t cells = 0;       // parts of the winds and masses that were proved one by one
  std::vector<ProvedCell> proofs;  // of the cells: what a certificate says
  double damping = 1;              // the least damping ratio of the loop in hover
  std::optional<TubeTrouble> trouble;
};

struct TubeOptions {
  std::size_t most_cells = 64;  // >= 1: a proof that takes more is given up
  bool by_spans = false;  // for a certificate: `proofs` have bounds that a checker finds again
};

// At every step of a millisecond, for all winds, gusts and vehicles that are allowed, the vehicle
// of simulate() is within the radius of the reference of that instant, from the trajectory's start
// until the end of `options.settle`. It starts within the errors of the start, `options.hover`
// before, and nothing is clipped. `options.wind`, `options.sensors` and the errors of `options` are
// not looked at.
//
// Preconditions: at least a millisecond of hovering before, an attitude loop of at most 4 ms, no
// delay of sensors, positive position gains; under the cascade no i and d of the position loop, and
// velocity gains with p > 0, i >= 0 and d >= 0.
// Disturbances and noise that the simulator draws from a normal distribution have no bound, and no
// claim is made for them.
//
// Cost: some 0.1 to 0.3 s a second of flight and cell, on a thread each. The same for any number of
// threads.
ProvedTube prove_tube(const ReferenceTrack& track, const FlightOptions& options,
                      const Disturbances& disturbances, const geom::Execution& run,
                      const TubeOptions& tube = {});

}  // namespace traj
