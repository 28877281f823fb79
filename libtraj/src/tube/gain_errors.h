#pragma once

// How the gains of a controller differ from what its profile says.

#include "traj/tube/prove_tube.h"
#include "tube/loop_state.h"

namespace traj {

// Shares, axis by axis: a gain is 1 + share times what it should be.
template <class S>
struct GainErrors {
  bool none = true;  // all are 0
  Triple<S> position, velocity, attitude, rates;
  Triple<S> velocity_i, velocity_d;  // of the cascade
  Triple<S> rates_i, rates_d;        // of the cascade; the geometric controller's lead is rates_d
};

// Any errors that are allowed.
template <class S>
GainErrors<S> gain_errors_within(const Disturbances& d) {
  const S any = S::within(0, d.gain_error);
  const Triple<S> all = {any, any, any};
  return {d.gain_error == 0, all, all, all, all, all, all, all, all};
}

// What a loop asks for with the gain k.
template <class S>
Triple<S> by_gain(const Vec3& k, const GainErrors<S>& errors, const Triple<S>& share,
                  const Triple<S>& error) {
  const Triple<S> asked = scaled(triple(k), error);
  return errors.none ? asked : asked + scaled(share, asked);
}

}  // namespace traj
