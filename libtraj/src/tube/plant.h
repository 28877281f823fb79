#pragma once

// The vehicle between two steps of a millisecond, seen from the frame that its controller wants.

#include <array>
#include <optional>

#include "traj/flight/quadrotor.h"
#include "tube/wanted_frame.h"

namespace traj {

inline constexpr double kMillisecond = 1e-3;  // s

// LaggedGusts that obey lag g' = n - g, with |n| <= most.
struct LaggedGusts {
  double lag = 1;   // s, > 0
  double most = 0;  // m/s
};

// What moves, between two steps of a millisecond. Lag and heading are those of the wanted frame.
template <class S>
struct Body {
  Triple<S> moved;  // m since the start of the period
  Triple<S> velocity, lag;
  S missing{};  // m/s2: what the motors' thrust lacks of what they are told
  S heading{};
  Triple<S> rates, spin;
  Triple<S> turned;    // rad/s since the controller last ran
  Triple<S> filtered;  // rad/s2: what it makes of that
};

// The same, with the direction of the thrust in place of the lag: attitudes then know nothing of
// how large the lift is.
template <class S>
struct TiltedBody {
  Triple<S> moved;  // m since the start of the period
  Triple<S> velocity;
  S tilt_x{}, tilt_y{};  // of the body's z axis, in the wanted frame
  S missing{};           // m/s2: lift's size minus thrust / believed mass
  S heading{};
  Triple<S> rates, spin;
  Triple<S> turned;    // rad/s since the controller last ran
  Triple<S> filtered;  // rad/s2: what it makes of that
};

// The body's frame, seen from the wanted one, in which the lift is (0, 0, its size).
template <class S>
Frame<S> frame_of(const Body<S>& body, const Wanted<S>& wanted) {
  return frame_along<S>({-body.lag.x, -body.lag.y, wanted.frame.size - body.lag.z}, body.heading);
}

// Its size is 1.
template <class S>
Frame<S> frame_of(const TiltedBody<S>& body, const Wanted<S>&) {
  using std::sqrt;
  return frame_along_unit<S>(
      {body.tilt_x, body.tilt_y, sqrt(1.0 - body.tilt_x * body.tilt_x - body.tilt_y * body.tilt_y)},
      body.heading);
}

// What holds during a millisecond.
template <class S>
struct Held : VehicleFactors<S> {
  S thrust{};               // m/s2 that is asked for
  std::optional<S> beyond;  // m/s2: the thrust minus the lift's size, for a TiltedBody
  Triple<S> spin;           // rad/s2 that are asked for
  Triple<S> wind;
};

template <class S>
Triple<S> gyroscopic(const Vec3& inertia, const Triple<S>& w) {  // J^-1 (w x J w)
  const Triple<S> product = cross(w, scaled(triple(inertia), w));
  return scaled(triple(inertia.cwiseInverse()), product);
}

// A Body or a TiltedBody, a millisecond later.
template <class B, class S>
B runge_kutta(const Quadrotor& q, const Wanted<S>& wanted, const B& body, const Held<S>& held);

// What the motors are told for it (N), as if no command were clipped.
template <class S>
std::array<S, 4> motors(const Quadrotor& q, const Held<S>& held);

// The share of a gust that is left after so many milliseconds.
double gust_kept(double gust_lag, int milliseconds);

// What blows in a period's millisecond j. Anything within `gust_most` may have come up meanwhile.
template <class S>
Triple<S> wind_in(const Triple<S>& wind, const Triple<S>& gust, const LaggedGusts& gusts, int j);

// Makes remainders symbols, k and the next two, so that what follows from them is known to be
// linear.
inline void name_errors(Triple<double>&, int) {}
template <int N>
void name_errors(Triple<TaylorModelOf<N>>& t, int k) {
  t = {t.x.named(k), t.y.named(k + 1), t.z.named(k + 2)};
}

// Lag, or tilt and what is missing, and heading as the next wanted frame sees them.
template <class S>
void turn_to(const Wanted<S>& wanted, const FrameChange<S>& d, Body<S>& body);
template <class S>
void turn_to(const Wanted<S>& wanted, const FrameChange<S>& d, TiltedBody<S>& body);

}  // namespace traj
