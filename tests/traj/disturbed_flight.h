#pragma once

// Flights in any wind, and winds that push as hard as they may.

#include <cmath>
#include <functional>
#include <vector>

#include "flight/geometric_controller.h"
#include "support/random_city.h"
#include "traj/flight/simulate.h"
#include "traj/tube/prove_tube.h"

namespace traj::testing {

// What is true of one flight.
struct Fate {
  Vec3 wind = Vec3::Zero();  // m/s, the mean wind
  double mass_error = 0;     // shares of what is believed
  double drag_error = 0;
  double motor_lag_error = 0;
  Vec3 inertia_error = Vec3::Zero();
  Vec3 place = Vec3::Zero();     // m, from where the reference begins
  Vec3 velocity = Vec3::Zero();  // m/s, then
  std::function<Vec3(long)> towards =
      {};  // m/s, what the gust runs towards from a step of 1 ms on, counted
           // from the start of the hovering before the trajectory
};

struct DisturbedFlight {
  std::vector<double> error;  // m, at each step from the trajectory's start on
  std::vector<Vec3> place;    // m, minus the reference
  std::vector<Vec3> velocity;
  std::vector<Vec3> rates;
  std::vector<Vec3> spin;  // rad/s2: the motors' torque over the believed inertia
  double tilt = 0;         // rad, the largest from the trajectory's start on
  bool saturated = false;
};

// The loop of traj::simulate() with gusts of our own: gust_lag g' = n - g, n held for a
// millisecond.
template <class Controller>
DisturbedFlight fly_under(const ReferenceTrack& track, const FlightOptions& options,
                          const Disturbances& d, const Fate& fate) {
  FlightOptions with = options;
  with.mass_error = fate.mass_error;
  with.drag_error = fate.drag_error;
  with.motor_lag_error = fate.motor_lag_error;
  with.inertia_error = fate.inertia_error;
  const Quadrotor vehicle = true_vehicle(with);
  const long before = std::lround(options.hover / kStep);
  const long steps = std::lround((track.duration() + options.settle) / kStep);
  std::size_t cursor = 0;
  QuadrotorState state;
  const Reference first = track.at(-1, cursor);
  state.position = first.position + fate.place;
  state.velocity = fate.velocity;
  state.attitude = Eigen::AngleAxisd(first.yaw, Vec3::UnitZ());
  state.thrust = Motors::Constant(vehicle.mass * 9.80665 / 4);
  Controller controller(options.quadrotor, options.gains, options.periods);
  Vec3 gust = Vec3::Zero();
  const double kept = std::exp(-kStep / d.gust_lag);
  DisturbedFlight out;
  for (long n = -before; n <= steps; ++n) {
    const Reference reference = track.at(static_cast<double>(n) * kStep, cursor);
    if (n >= 0) {
      out.place.push_back(state.position - reference.position);
      out.error.push_back(out.place.back().norm());
      out.velocity.push_back(state.velocity);
      out.rates.push_back(state.body_rates);
      out.spin.push_back(torque_of(vehicle, state.thrust).cwiseQuotient(options.quadrotor.inertia));
      const double upright = (state.attitude * Vec3::UnitZ()).z();
      out.tilt = std::max(out.tilt, std::acos(std::min(upright, 1.0)));
    }
    const Measured seen{state.position, state.velocity, state.attitude, state.body_rates};
    const QuadrotorInput input{controller.command(n + before, reference, seen), fate.wind + gust};
    out.saturated |= controller.take_saturated();
    state = integrate(vehicle, state, input, kStep);
    if (fate.towards) gust = kept * gust + (1 - kept) * fate.towards(n + before);
  }
  return out;
}

inline DisturbedFlight fly(const ReferenceTrack& track, const FlightOptions& options,
                           const Disturbances& d, const Fate& fate) {
  return options.law == ControlLaw::cascade
             ? fly_under<CascadeController>(track, options, d, fate)
             : fly_under<GeometricController>(track, options, d, fate);
}

inline Vec3 direction(support::Random& random) {
  Vec3 v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

// How far along `push` the vehicle is, so many ms after a gust of 1 m/s along it ran up for one
// step.
inline std::vector<double> response(const FlightOptions& options, double gust_lag, const Vec3& push,
                                    double seconds) {
  FlightOptions hovering = options;
  hovering.hover = 0;
  hovering.settle = 0;
  State there;
  const ReferenceTrack track({{hermite(there, there, seconds)}});
  const Disturbances d{.gust_lag = gust_lag};
  const Fate pulse{.towards = [&](long n) { return n == 0 ? Vec3(push) : Vec3::Zero(); }};
  std::vector<double> out;
  for (const Vec3& place : fly(track, hovering, d, pulse).place) out.push_back(push.dot(place));
  return out;
}

// A flight that is allowed: winds and masses at the edge or anywhere, and gusts by chance (0), that
// jump from one end to the other (1), or that fit the response in hover, so that they push as far
// as they can along some direction at some instant (2).
inline Fate drawn_fate(support::Random& random, const FlightOptions& options, const Disturbances& d,
                       double duration, int kind) {
  const bool edge = random.uniform(0, 1) < 0.7;
  const Vec3 push = direction(random);
  Fate fate;
  const double share = edge ? 1 : random.uniform(0, 1);
  fate.wind =
      d.wind + d.wind_spread * share * (random.uniform(0, 1) < 0.5 ? push : direction(random));
  const auto off = [&](double most) {
    return most * (edge ? (random.uniform(0, 1) < 0.5 ? -1 : 1) : random.uniform(-1, 1));
  };
  fate.mass_error = off(d.mass_error);
  fate.drag_error = off(d.drag_error);
  fate.motor_lag_error = off(d.motor_lag_error);
  for (double& axis : fate.inertia_error) axis = off(d.inertia_error);
  fate.place = off(d.start_error) * push;
  fate.velocity = off(d.start_speed) * (random.uniform(0, 1) < 0.5 ? push : direction(random));
  const long all = std::lround((options.hover + duration + options.settle) / kStep);
  std::vector<Vec3> towards(static_cast<std::size_t>(all + 1), Vec3::Zero());
  if (kind == 2) {
    const long seconds = options.law == ControlLaw::cascade ? 12 : 4;
    const std::vector<double> kernel =
        response(options, d.gust_lag, push, static_cast<double>(seconds));
    const auto last =
        static_cast<long>(random.uniform(options.hover / kStep, static_cast<double>(all)));
    for (long n = 0; n < last; ++n) {
      const auto age = static_cast<std::size_t>(std::min<long>(last - n, 1000 * seconds - 1));
      towards[static_cast<std::size_t>(n)] = (kernel[age] < 0 ? -1 : 1) * d.gust_most * push;
    }
  } else {
    Vec3 now = d.gust_most * push;
    const double hold = std::exp(random.uniform(std::log(0.003), std::log(2)));
    for (Vec3& n : towards) {
      if (random.uniform(0, 1) < kStep / hold) {
        now = kind == 1 ? Vec3(-now) : Vec3(d.gust_most * random.uniform(0, 1) * direction(random));
      }
      n = now;
    }
  }
  fate.towards = [towards = std::move(towards)](long n) {
    return towards[static_cast<std::size_t>(n)];
  };
  return fate;
}

// The largest error over the tube's radius of that instant.
inline double worst_share(const ProvedTube& tube, const DisturbedFlight& flight) {
  double worst = 0;
  for (std::size_t n = 0; n < flight.error.size(); ++n) {
    const std::size_t k = std::min(n / 100, tube.radius.size() - 1);
    worst = std::max(worst, flight.error[n] / tube.radius[k]);
  }
  return worst;
}

}  // namespace traj::testing
