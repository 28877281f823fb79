#pragma once

// The state of vehicle, controller and wind when the attitude loop runs, in numbers or in bounds.

#include <array>

#include "geom/base/vec3.h"
#include "tube/taylor_model.h"

namespace traj {

// Three of a scalar that is a double or a Taylor model.
template <class S>
struct Triple {
  S x{}, y{}, z{};
};

template <class S, class T>
using Wider = decltype(S() + T());

template <class S, class T>
Triple<Wider<S, T>> operator+(const Triple<S>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S, class T>
Triple<Wider<S, T>> operator-(const Triple<S>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S, class T>
Triple<Wider<S, T>> operator*(const S& k, const Triple<T>& a) {
  return {k * a.x, k * a.y, k * a.z};
}
template <class S, class T>
Wider<S, T> dot(const Triple<S>& a, const Triple<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S, class T>
Triple<Wider<S, T>> cross(const Triple<S>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S, class T>
Triple<Wider<S, T>> scaled(const Triple<S>& a, const Triple<T>& b) {  // axis by axis
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Triple<double> triple(const geom::Vec3& v) { return {v.x(), v.y(), v.z()}; }

// How far a vehicle is from a reference.
template <class S>
struct Off {
  Triple<S> place;     // m
  Triple<S> velocity;  // m/s
};

// How the true vehicle differs from the one that the controller believes. It does not change.
template <class S>
struct VehicleFactors {
  S lightness{};      // believed mass over true mass
  S drag{};           // true drag over believed drag
  S quickness{};      // believed over true time constant of the motors
  Triple<S> agility;  // believed over true inertia about each axis

  void set_factors(const VehicleFactors& factors) { *this = factors; }
};

// The coordinates from k on.
template <class S, class F>
void for_each_factor(VehicleFactors<S>& v, int k, const F& f) {
  f(k, v.lightness), f(k + 1, v.drag), f(k + 2, v.quickness);
  f(k + 3, v.agility.x), f(k + 4, v.agility.y), f(k + 5, v.agility.z);
}

// The state when the attitude loop runs, in coordinates in which the closed loop is nearly linear:
// `lift` is what the controller asks for then. The wanted frame has its z axis along the lift and
// the reference's heading, as attitude_along() says; what belongs to the body is seen from there.
template <class S>
struct LoopState : VehicleFactors<S> {
  Triple<S> lift;      // m/s2: kp (p_r - p) + kv (v_r - v) + a_r + g
  Triple<S> velocity;  // m/s
  Triple<S> lag;       // m/s2, in the wanted frame: lift - thrust / believed mass
  S heading{};         // rad, in the wanted frame: of the body's x axis
  Triple<S> rates;     // rad/s, about the body's axes
  Triple<S> spin;      // rad/s2: the motors' torque over inertia
  Triple<S> filtered;  // rad/s2: the controller's low-passed angular acceleration
  Triple<S> turned;    // rad/s: rates minus those that it saw last
  Triple<S> gust;      // m/s
  Triple<S> wind;      // m/s: the mean wind, which does not change
};
inline constexpr int kLoopStates = 34;

template <class S, class F>
void for_each(LoopState<S>& s, const F& f) {
  int k = 0;
  const auto three = [&](Triple<S>& t) {
    f(k, t.x), f(k + 1, t.y), f(k + 2, t.z);
    k += 3;
  };
  three(s.lift), three(s.velocity), three(s.lag);
  f(k++, s.heading);
  three(s.rates), three(s.spin), three(s.filtered), three(s.turned), three(s.gust), three(s.wind);
  for_each_factor(s, k, f);
}

// Where coordinates stand among the rows of a vector of deviations. Those from `wind` on do not
// change.
struct GeometricRows {
  static constexpr int kStates = kLoopStates;
  static constexpr int kPadded = kLoopStates;
  static constexpr int kNamed = 15;  // errors: of the torques of each millisecond, of the lift
  static constexpr int kNamedKinds = 6;
  static constexpr int kind_of_named(int k) { return k < 12 ? k % 3 : k - 9; }
  static constexpr std::size_t kOldest = 6;  // halves of a second, before terms become a box
  static constexpr int kVelocity = 3;
  static constexpr int kSpin = 13;  // from here on, angular accelerations
  static constexpr int kPastSpins = 19;
  static constexpr int kGust = 22;
  static constexpr int kWind = 25;
  static constexpr int kLightness = 28;
  static constexpr int kDrag = 29;
  static constexpr int kQuickness = 30;
  static constexpr int kAgility = 31;
  // Lift, velocity and heading are slow; what is fast soon follows them.
  static constexpr std::array<int, 7> kSlow = {0, 1, 2, 3, 4, 5, 9};

  template <class S>
  using State = LoopState<S>;
  using Model = TaylorModel;
};

}  // namespace traj
