#pragma once

// The state of vehicle, cascade and wind when the attitude loop runs, in numbers or in bounds.

#include "tube/loop_state.h"

namespace traj {

// Before the controller runs. `lift` is what it asks for since the position loop last ran. The
// wanted frame has its z axis along that and the reference's heading of now.
template <class S>
struct CascadeState : VehicleFactors<S> {
  Triple<S> lift;        // m/s2: what the position loop asked for, gravity included
  Triple<S> velocity;    // m/s
  S tilt_x{}, tilt_y{};  // of the body's z axis, in the wanted frame
  S missing{};           // m/s2: the lift's size minus thrust / believed mass
  S heading{};           // rad, in the wanted frame: of the body's x axis
  Triple<S> rates;       // rad/s, about the body's axes
  Triple<S> spin;        // rad/s2: the motors' torque over inertia
  Triple<S>
      filtered;  // rad/s2: the controller's low-passed angular acceleration, rates of now seen
  Triple<S> integral;  // rad/s2: of the rate loop
  Triple<S> missed;    // m/s: the velocity loop's error when it last ran
  Triple<S> slope;     // m/s2: its derivative, low-passed
  Triple<S> due;       // m/s2: how the lift would change if the position loop ran now
  Triple<S> gust;      // m/s
  Triple<S> wind;      // m/s: the mean wind, which does not change
};

template <class S, class F>
void for_each(CascadeState<S>& s, const F& f) {
  int k = 0;
  const auto three = [&](Triple<S>& t) {
    f(k, t.x), f(k + 1, t.y), f(k + 2, t.z);
    k += 3;
  };
  three(s.lift), three(s.velocity);
  f(k, s.tilt_x), f(k + 1, s.tilt_y), f(k + 2, s.missing), f(k + 3, s.heading);
  k += 4;
  three(s.rates), three(s.spin), three(s.filtered), three(s.integral);
  three(s.missed), three(s.slope), three(s.due), three(s.gust), three(s.wind);
  for_each_factor(s, k, f);
}

// Where coordinates stand among the rows of a vector of deviations. Those from `wind` on do not
// change.
struct CascadeRows {
  static constexpr int kStates = 43;
  static constexpr int kPadded = 44;
  // Errors: of the rates that are wanted, of torques, of the velocity, of what the position loop
  // reads.
  static constexpr int kNamed = 21;
  static constexpr int kNamedKinds = 12;
  static constexpr int kind_of_named(int k) { return k < 3 ? k : k < 15 ? 3 + k % 3 : k - 9; }
  static constexpr std::size_t kOldest = 12;  // halves of a second, before terms become a box
  static constexpr int kVelocity = 3;
  static constexpr int kSpin = 13;  // from here on, angular accelerations
  static constexpr int kPastSpins = 22;
  static constexpr int kMissed = 22;
  static constexpr int kSlope = 25;
  static constexpr int kDue = 28;
  static constexpr int kGust = 31;
  static constexpr int kWind = 34;
  static constexpr int kLightness = 37;
  static constexpr int kDrag = 38;
  static constexpr int kQuickness = 39;
  static constexpr int kAgility = 40;
  // Lift, velocity, heading, the integral of rates and the velocity's error are slow.
  static constexpr std::array<int, 13> kSlow = {0, 1, 2, 3, 4, 5, 9, 19, 20, 21, 22, 23, 24};

  template <class S>
  using State = CascadeState<S>;
  using Model = CascadeModel;
};

}  // namespace traj
