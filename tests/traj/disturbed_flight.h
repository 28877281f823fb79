#pragma once

// Flights in any wind, and winds that push as hard as they may.

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "flight/geometric_controller.h"
#include "support/random_city.h"
#include "traj/flight/simulate.h"
#include "traj/tube/prove_tube.h"

namespace traj::testing {

// What a reading of the sensors is off by.
struct Misread {
  Vec3 place = Vec3::Zero();     // m
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 turn = Vec3::Zero();      // rad, as Readings::turn
  Vec3 rates = Vec3::Zero();     // rad/s
};

// What is true of one flight.
struct Fate {
  Vec3 wind = Vec3::Zero();  // m/s, the mean wind
  double mass_error = 0;     // shares of what is believed
  double drag_error = 0;
  double motor_lag_error = 0;
  Vec3 inertia_error = Vec3::Zero();
  std::optional<Gains> gains = {};  // else those that are believed
  Vec3 place = Vec3::Zero();        // m, from where the reference begins
  Vec3 velocity = Vec3::Zero();     // m/s, then
  std::function<Vec3(long)> towards =
      {};  // m/s, what the gust runs towards from a step of 1 ms on, counted
           // from the start of the hovering before the trajectory
  std::function<Misread(long)> misread = {};  // in a step, counted likewise
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

// What the controller follows at each step, from the start of the hovering on. Many flights of one
// trajectory share it.
struct References {
  References(const ReferenceTrack& track, const FlightOptions& options)
      : before(std::lround(options.hover / kStep)),
        steps(std::lround((track.duration() + options.settle) / kStep)) {
    std::size_t cursor = 0;
    first = track.at(-1, cursor);
    for (long n = -before; n <= steps; ++n) {
      at.push_back(track.at(static_cast<double>(n) * kStep, cursor));
    }
  }

  long before, steps;  // of 1 ms, before and after the trajectory's start
  Reference first;
  std::vector<Reference> at;
};

// The loop of traj::simulate() with gusts of our own: gust_lag g' = n - g, n held for a
// millisecond. Calls `see` with the state and the reference of each step from the trajectory's
// start on. Returns whether a motor saturated.
template <class Controller, class See>
bool fly_seen(const References& references, const FlightOptions& options, const Quadrotor& vehicle,
              const Disturbances& d, const Fate& fate, See&& see) {
  QuadrotorState state;
  state.position = references.first.position + fate.place;
  state.velocity = fate.velocity;
  state.attitude = Eigen::AngleAxisd(references.first.yaw, Vec3::UnitZ());
  state.thrust = Motors::Constant(vehicle.mass * 9.80665 / 4);
  Controller controller(options.quadrotor, fate.gains.value_or(options.gains), options.periods);
  Vec3 gust = Vec3::Zero();
  const double kept = std::exp(-kStep / d.gust_lag);
  bool saturated = false;
  for (long n = -references.before; n <= references.steps; ++n) {
    const Reference& reference = references.at[static_cast<std::size_t>(n + references.before)];
    if (n >= 0) see(state, reference);
    Measured seen{state.position, state.velocity, state.attitude, state.body_rates};
    if (fate.misread) {
      const Misread off = fate.misread(n + references.before);
      const Vec3 half = 0.5 * off.turn;
      seen.position += off.place;
      seen.velocity += off.velocity;
      seen.attitude =
          (state.attitude * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
      seen.body_rates += off.rates;
    }
    const QuadrotorInput input{controller.command(n + references.before, reference, seen),
                               fate.wind + gust};
    saturated |= controller.take_saturated();
    state = integrate(vehicle, state, input, kStep);
    if (fate.towards) gust = kept * gust + (1 - kept) * fate.towards(n + references.before);
  }
  return saturated;
}

inline Quadrotor vehicle_of(FlightOptions options, const Fate& fate) {
  options.mass_error = fate.mass_error;
  options.drag_error = fate.drag_error;
  options.motor_lag_error = fate.motor_lag_error;
  options.inertia_error = fate.inertia_error;
  return true_vehicle(options);
}

template <class See>
bool fly_seen(const References& references, const FlightOptions& options, const Disturbances& d,
              const Fate& fate, See&& see) {
  const Quadrotor vehicle = vehicle_of(options, fate);
  return options.law == ControlLaw::cascade
             ? fly_seen<CascadeController>(references, options, vehicle, d, fate, see)
             : fly_seen<GeometricController>(references, options, vehicle, d, fate, see);
}

inline DisturbedFlight fly(const ReferenceTrack& track, const FlightOptions& options,
                           const Disturbances& d, const Fate& fate) {
  const Quadrotor vehicle = vehicle_of(options, fate);
  DisturbedFlight out;
  out.saturated =
      fly_seen(References(track, options), options, d, fate,
               [&](const QuadrotorState& state, const Reference& reference) {
                 out.place.push_back(state.position - reference.position);
                 out.error.push_back(out.place.back().norm());
                 out.velocity.push_back(state.velocity);
                 out.rates.push_back(state.body_rates);
                 out.spin.push_back(
                     torque_of(vehicle, state.thrust).cwiseQuotient(options.quadrotor.inertia));
                 const double upright = (state.attitude * Vec3::UnitZ()).z();
                 out.tilt = std::max(out.tilt, std::acos(std::min(upright, 1.0)));
               });
  return out;
}

inline Vec3 direction(support::Random& random) {
  Vec3 v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

inline std::array<Vec3*, 13> gains_of(Gains& k) {
  GeometricGains& g = k.geometric;
  return {&g.position,   &g.velocity,   &g.attitude,   &g.rates,      &g.lead,
          &k.position.p, &k.velocity.p, &k.velocity.i, &k.velocity.d, &k.attitude,
          &k.rates.p,    &k.rates.i,    &k.rates.d};
}

// Draws flights that are allowed: winds and masses at the edge or anywhere, and gusts and readings
// by chance (0), that jump from one end to the other (1), or that fit the response in hover, so
// that they push as far as they can along some direction at some instant (2).
class Fates {
 public:
  // `duration` of the trajectory, s.
  Fates(const FlightOptions& options, const Disturbances& d, double duration)
      : options_(options),
        d_(d),
        steps_(std::lround((options.hover + duration + options.settle) / kStep)) {}

  Fate drawn(support::Random& random, int kind) {
    const bool edge = random.uniform(0, 1) < 0.7;
    const Vec3 push = direction(random);
    Fate fate;
    const double share = edge ? 1 : random.uniform(0, 1);
    fate.wind =
        d_.wind + d_.wind_spread * share * (random.uniform(0, 1) < 0.5 ? push : direction(random));
    const auto off = [&](double most) {
      return most * (edge ? (random.uniform(0, 1) < 0.5 ? -1 : 1) : random.uniform(-1, 1));
    };
    fate.mass_error = off(d_.mass_error);
    fate.drag_error = off(d_.drag_error);
    fate.motor_lag_error = off(d_.motor_lag_error);
    for (double& axis : fate.inertia_error) axis = off(d_.inertia_error);
    if (d_.gain_error > 0) {
      fate.gains = options_.gains;
      for (Vec3* gain : gains_of(*fate.gains)) {
        for (double& axis : *gain) axis *= 1 + off(d_.gain_error);
      }
    }
    fate.place = off(d_.start_error) * push;
    fate.velocity = off(d_.start_speed) * (random.uniform(0, 1) < 0.5 ? push : direction(random));
    const auto last =
        static_cast<long>(random.uniform(options_.hover / kStep, static_cast<double>(steps_)));
    fate.towards = [towards = kind == 2 ? fitted(last, push) : jumping(random, push, kind)](
                       long n) { return towards[static_cast<std::size_t>(n)]; };
    if (!d_.has_noise()) return fate;
    fate.misread = [misread = kind == 2 ? misread_to(last, push) : misread_by(random, kind)](
                       long n) { return misread[static_cast<std::size_t>(n)]; };
    return fate;
  }

 private:
  // A member of Misread, how large it may be, and for how many ms it counts.
  struct Noise {
    Vec3 Misread::*of;
    double most;
    int period;
  };
  std::array<Noise, 4> noises() const {
    const LoopPeriods& p = options_.periods;
    const bool cascade = options_.law == ControlLaw::cascade;
    const int position = cascade ? p.position : p.attitude;
    return {Noise{&Misread::place, d_.place_noise, position},
            Noise{&Misread::velocity, d_.velocity_noise, position},
            Noise{&Misread::turn, d_.attitude_noise, cascade ? p.attitude : 1},
            Noise{&Misread::rates, d_.rate_noise, 1}};
  }

  std::vector<Misread> misread_by(support::Random& random, int kind) const {
    std::vector<Misread> out(static_cast<std::size_t>(steps_ + 1));
    for (const Noise& noise : noises()) {
      Vec3 now;
      for (double& axis : now) axis = noise.most * (random.uniform(0, 1) < 0.5 ? -1 : 1);
      const double hold = std::exp(random.uniform(std::log(0.001), std::log(2)));
      for (Misread& one : out) {
        if (random.uniform(0, 1) < kStep / hold) {
          for (double& axis : now) axis = kind == 1 ? -axis : noise.most * random.uniform(-1, 1);
        }
        one.*noise.of = now;
      }
    }
    return out;
  }

  std::vector<Misread> misread_to(long last, const Vec3& push) {
    const auto all = noises();
    if (misread_response_.empty()) {
      for (const Noise& noise : all) respond_to(noise);
    }
    std::vector<Misread> out(static_cast<std::size_t>(steps_ + 1));
    for (long n = 0; n < last; ++n) {
      for (std::size_t k = 0; k < all.size(); ++k) {
        for (int axis = 0; axis < 3; ++axis) {
          const auto& response = misread_response_[3 * k + static_cast<std::size_t>(axis)];
          const auto age = std::min(static_cast<std::size_t>(last - (n - n % all[k].period)),
                                    response.size() - 1);
          (out[static_cast<std::size_t>(n)].*all[k].of)[axis] =
              (response[age].dot(push) < 0 ? -1 : 1) * all[k].most;
        }
      }
    }
    return out;
  }

  // Where a hovering vehicle is, so many ms after it misread one thing along one axis.
  void respond_to(const Noise& noise) {
    for (int axis = 0; axis < 3; ++axis) {
      Fate pulse;
      pulse.misread = [&](long n) {
        Misread out;
        if (n < noise.period) (out.*noise.of)[axis] = 1e-3;
        return out;
      };
      misread_response_.push_back(hovering(pulse));
    }
  }

  std::vector<Vec3> jumping(support::Random& random, const Vec3& push, int kind) const {
    std::vector<Vec3> out(static_cast<std::size_t>(steps_ + 1));
    Vec3 now = d_.gust_most * push;
    const double hold = std::exp(random.uniform(std::log(0.003), std::log(2)));
    for (Vec3& n : out) {
      if (random.uniform(0, 1) < kStep / hold) {
        now =
            kind == 1 ? Vec3(-now) : Vec3(d_.gust_most * random.uniform(0, 1) * direction(random));
      }
      n = now;
    }
    return out;
  }

  std::vector<Vec3> fitted(long last, const Vec3& push) {
    if (response_.empty()) respond();
    std::vector<Vec3> out(static_cast<std::size_t>(steps_ + 1), Vec3::Zero());
    for (long n = 0; n < last; ++n) {
      const auto age = std::min(static_cast<std::size_t>(last - n), response_.size() - 1);
      const double along = response_[age].dot(push.cwiseAbs2());
      out[static_cast<std::size_t>(n)] = (along < 0 ? -1 : 1) * d_.gust_most * push;
    }
    return out;
  }

  // How far along each axis a hovering vehicle is, so many ms after a gust of 1 m/s along that axis
  // ran up for one step.
  void respond() {
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<Vec3> places = hovering(
          {.towards = [&](long n) -> Vec3 { return Vec3::Unit(axis) * (n == 0 ? 1 : 0); }});
      response_.resize(places.size(), Vec3::Zero());
      for (std::size_t n = 0; n < places.size(); ++n) response_[n][axis] = places[n][axis];
    }
  }

  std::vector<Vec3> hovering(const Fate& fate) const {
    FlightOptions options = options_;
    options.hover = 0;
    options.settle = 0;
    const double seconds = options.law == ControlLaw::cascade ? 12 : 4;
    const References references(ReferenceTrack({{hermite({}, {}, seconds)}}), options);
    std::vector<Vec3> out;
    fly_seen(references, options, {.gust_lag = d_.gust_lag}, fate,
             [&](const QuadrotorState& state, const Reference& reference) {
               out.push_back(state.position - reference.position);
             });
    return out;
  }

  FlightOptions options_;
  Disturbances d_;
  long steps_;
  std::vector<Vec3> response_;
  std::vector<std::vector<Vec3>> misread_response_;  // of each noise, along each axis
};

// An error over the tube's radius of that step from the trajectory's start on.
inline double share_of(const ProvedTube& tube, std::size_t step, double error) {
  return error / tube.radius[std::min(step / 100, tube.radius.size() - 1)];
}

inline double worst_share(const ProvedTube& tube, const DisturbedFlight& flight) {
  double worst = 0;
  for (std::size_t n = 0; n < flight.error.size(); ++n) {
    worst = std::max(worst, share_of(tube, n, flight.error[n]));
  }
  return worst;
}

}  // namespace traj::testing
