#pragma once

// The closed loop of vehicle and geometric controller, from one run of the attitude loop to the
// next.
//
// docs/tube.md derives the equations; a test compares them with traj::simulate().

#include <array>
#include <vector>

#include "traj/flight/gains.h"
#include "traj/flight/reference.h"
#include "tube/gain_errors.h"
#include "tube/loop_state.h"
#include "tube/readings.h"

namespace traj {

static_assert(GeometricRows::kNamed == 3 * kLongestPeriod + 3);
static_assert(kLoopStates + GeometricRows::kNamed <= TaylorModel::kSymbols);

// The vehicle and its controller, as numbers.
struct Loop {
  Quadrotor model;
  GeometricGains gains;
  int period = kLongestPeriod;  // ms, of the attitude loop, at most kLongestPeriod
  double gust_lag = 1;          // s, > 0
  double gust_most = 0;         // m/s: bounds the length of what the gusts run towards
};

// The references at the start of a period and at its end.
struct LoopReferences {
  Reference now;
  Reference next;
};

// The state a period later, and of each millisecond until then what motors are told (N), as if no
// command were clipped, how far the vehicle has moved (m), and its tilt. Remainders are not
// finite where a thrust or a lift may point sideways.
template <class S>
struct LoopStep {
  LoopState<S> state;
  std::vector<std::array<S, 4>> commands;
  std::vector<Triple<S>> moved;  // after 1, 2, ... ms
  std::vector<S> upright;        // after 1, 2, ... ms: the cosine of the tilt
};

// Second-order terms of the torques become symbols, from kLoopStates on, three a millisecond, and
// three more for what the lift is off by readings and gains.
template <class S>
LoopStep<S> loop_step(const Loop& loop, const LoopState<S>& state, const LoopReferences& references,
                      const Readings<S>& readings = {}, const GainErrors<S>& gains = {});

// The state of a vehicle at rest on a reference that rests, its heading too. Thrust holds its true
// weight.
LoopState<TaylorModel> resting(const TaylorModel& lightness);

// The same for a vehicle that is not there, or not at rest, when its controller first runs.
LoopState<TaylorModel> starting(const Loop& loop, const TaylorModel& lightness,
                                const Reference& first, const Off<TaylorModel>& off);

// The share of a gust that is left after so many milliseconds. What came meanwhile is at most the
// rest times gust_most.
double gust_kept(const Loop& loop, int milliseconds);

}  // namespace traj
