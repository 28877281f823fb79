#pragma once

// The closed loop of vehicle and cascade, from one run of the attitude loop to the next.
//
// docs/tube.md derives the equations; a test compares them with traj::simulate().

#include <vector>

#include "traj/flight/controller.h"
#include "tube/cascade_state.h"
#include "tube/gain_errors.h"
#include "tube/loop_step.h"
#include "tube/plant.h"
#include "tube/readings.h"

namespace traj {

// The vehicle and its controller, as numbers.
struct CascadeLoop {
  Quadrotor model;
  Gains gains;  // without integral or derivative action on the position
  LoopPeriods periods;
  LaggedGusts gusts;
};

// How the velocity's error makes the lift change when the position loop runs: by drift * of_drift +
// missed * of_missed - slope * of_slope, axis by axis, where the error has changed by `drift` since
// the loop last ran.
struct LiftGains {
  explicit LiftGains(const CascadeLoop& loop);

  double period;  // s
  double share;   // of the low pass
  Vec3 of_drift;  // 1/s, > 0
  Vec3 of_missed;
  Vec3 of_slope;
};

// The references of a period.
struct CascadeReferences {
  std::vector<Reference> at;       // after 0, 1, ... ms, the period's end included
  Vec3 last_asked = Vec3::Zero();  // m/s2: the acceleration when the position loop last ran
  long step = 0;                   // ms since the controller's first run
};

// What the controller asks for when the position loop runs: each may be clipped.
template <class S>
struct PositionRun {
  int millisecond = 0;
  Triple<S> velocity;      // m/s
  Triple<S> before;        // m/s2: the acceleration with the integral as it was,
  Triple<S> acceleration;  // m/s2: and as it is now
  Triple<S> lift;          // m/s2
};

// What the rate loop asks for in a millisecond: each may be clipped.
template <class S>
struct RateRun {
  Triple<S> before;  // rad/s2: with the integral as it was,
  Triple<S> spin;    // rad/s2: and as it is now
};

// Of each millisecond what motors are told (N), how far the vehicle has moved since the start (m),
// and its tilt, as if nothing were clipped. Remainders are not finite where a thrust or a lift may
// point sideways.
template <class S>
struct CascadeStep {
  CascadeState<S> state;
  std::vector<std::array<S, 4>> commands;
  std::vector<Triple<S>> moved;  // after 1, 2, ... ms
  std::vector<S> upright;        // after 1, 2, ... ms: the cosine of the tilt
  std::vector<PositionRun<S>> runs;
  std::vector<RateRun<S>> turns;  // of each millisecond
  Triple<S> rates;                // rad/s, that the attitude loop asks for
};

// Second-order terms of the torques become symbols, behind the state's, three a millisecond. So do
// those of the rates that are wanted, of the velocity, and what the position loop reads.
template <class S>
CascadeStep<S> cascade_step(const CascadeLoop& loop, const CascadeState<S>& state,
                            const CascadeReferences& references, const Readings<S>& readings = {},
                            const GainErrors<S>& gains = {});

// The state of a vehicle at rest on a reference that rests, its heading too. Thrust holds its true
// weight.
CascadeState<CascadeRows::Model> cascade_at_rest(const CascadeRows::Model& lightness);

// The same for a vehicle that is not there, or not at rest, when its controller first runs.
CascadeState<CascadeRows::Model> cascade_starting(const CascadeLoop& loop,
                                                  const CascadeRows::Model& lightness,
                                                  const Reference& first,
                                                  const Off<CascadeRows::Model>& off,
                                                  const GainErrors<CascadeRows::Model>& gains = {});

}  // namespace traj
