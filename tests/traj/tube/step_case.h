#pragma once

// What the tests of both controllers' steps share.

#include <gtest/gtest.h>

#include "traj/disturbed_flight.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/flights.h"
#include "tube/gain_errors.h"
#include "tube/loop_state.h"
#include "tube/readings.h"

namespace traj::testing {

inline FlightOptions flight_of(std::string_view vehicle, ControlLaw law = ControlLaw::geometric) {
  const auto profile = vehicle_named(vehicle);
  FlightOptions options{.quadrotor = *quadrotor_of(profile->airframe)};
  options.gains = *profile->airframe.gains;
  options.law = law;
  return options;
}

// A bend that climbs, with a heading that turns.
inline Trajectory bend(double yaw) {
  State a, b, c;
  b.position = {6, 2, 3};
  b.velocity = {1.5, 1.5, 0.3};
  c.position = {8, 9, 4};
  Trajectory out{{hermite(a, b, 5), hermite(b, c, 5)}};
  for (Segment& s : out.segments) {
    s.yaw.emplace();
    for (int i = 0; i < 8; ++i) (*s.yaw)[static_cast<std::size_t>(i)] = yaw;
  }
  for (int i = 0; i < 8; ++i) {
    const double share = i < 4 ? 0 : 1;
    (*out.segments[0].yaw)[static_cast<std::size_t>(i)] = yaw + 1.3 * share;
    (*out.segments[1].yaw)[static_cast<std::size_t>(i)] = yaw + 1.3;
  }
  return out;
}

// The middle of each coordinate.
template <class Rows>
typename Rows::template State<double> numbers(
    typename Rows::template State<typename Rows::Model> state) {
  typename Rows::template State<double> out;
  std::vector<double> values;
  for_each(state, [&](int, const typename Rows::Model& m) { values.push_back(m.c); });
  for_each(out, [&](int i, double& v) { v = values[static_cast<std::size_t>(i)]; });
  return out;
}

// Of both controllers.
template <class S, class F>
void for_each(GainErrors<S>& e, const F& f) {
  for (Triple<S>* of : {&e.position, &e.velocity, &e.attitude, &e.rates, &e.velocity_i,
                        &e.velocity_d, &e.rates_i, &e.rates_d}) {
    f(of->x), f(of->y), f(of->z);
  }
}

inline Vec3 vector(const Triple<double>& t) { return {t.x, t.y, t.z}; }

inline Gains off_by(Gains k, const GainErrors<double>& e) {
  const auto scale = [](Vec3& gain, const Triple<double>& share) {
    gain = gain.cwiseProduct(Vec3::Ones() + vector(share));
  };
  scale(k.geometric.position, e.position), scale(k.position.p, e.position);
  scale(k.geometric.velocity, e.velocity), scale(k.velocity.p, e.velocity);
  scale(k.geometric.attitude, e.attitude), scale(k.attitude, e.attitude);
  scale(k.geometric.rates, e.rates), scale(k.rates.p, e.rates);
  scale(k.geometric.lead, e.rates_d), scale(k.rates.d, e.rates_d);
  scale(k.velocity.i, e.velocity_i), scale(k.velocity.d, e.velocity_d);
  scale(k.rates.i, e.rates_i);
  return k;
}

// A flight in wind and gusts by a vehicle that is not as believed, and the state that knows it.
struct OddFlight {
  Fate fate;
  GainErrors<double> gains;
  double kept = 0;  // of a gust, a millisecond later
  DisturbedFlight flown;

  // The gust runs up in the last step of a period, so that the equations know it whole.
  // It begins off its place and not at rest.
  OddFlight(const ReferenceTrack& track, const FlightOptions& options, double error,
            std::uint64_t seed)
      : kept(std::exp(-kStep)) {
    support::Random random(seed);
    fate.wind = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.3)};
    const Vec3 push = 0.3 * direction(random);
    const int period = options.periods.attitude;
    fate.towards = [=, kept = kept](long n) {
      return n % period == period - 1
                 ? Vec3(push * std::sin(0.01 * static_cast<double>(n)) / (1 - kept) * 0.02)
                 : Vec3::Zero();
    };
    fate.mass_error = error;
    fate.drag_error = 3 * error;
    fate.motor_lag_error = -error;
    fate.inertia_error = error * Vec3(1, -1, 2);
    gains.none = error == 0;
    for_each(gains, [&](double& share) { share = error * random.uniform(-1, 1); });
    fate.gains = off_by(options.gains, gains);
    const double off = (options.law == ControlLaw::cascade ? 2 : 0.02) * error;
    fate.place = off * direction(random);
    fate.velocity = off * direction(random);
    const double noise = options.law == ControlLaw::cascade ? error : 0.1 * error;
    fate.misread = [=](long n) {
      const auto wave = [&](double size, double rate) {
        const double t = rate * static_cast<double>(n + 1);
        return Vec3(noise * size * Vec3(std::sin(t), std::sin(2.3 * t + 1), std::cos(t)));
      };
      return Misread{wave(0.02, 0.9), wave(0.05, 1.1), wave(0.02, 2.7), wave(0.05, 3.1)};
    };
    flown = fly(track, options, {}, fate);
    EXPECT_FALSE(flown.saturated);
  }

  template <class State>
  void set(State& s) const {
    s.wind = triple(fate.wind);
    s.drag = 1 + fate.drag_error;
    s.quickness = 1 / (1 + fate.motor_lag_error);
    s.agility = triple((Vec3::Ones() + fate.inertia_error).cwiseInverse());
  }

  // Of its start, without ranges.
  template <class Model>
  Off<Model> off() const {
    const auto models = [](const Vec3& v) { return Triple<Model>{v.x(), v.y(), v.z()}; };
    return {models(fate.place), models(fate.velocity)};
  }

  // What is read in the period that begins `step` ms after the first, whose position loop runs
  // `run` ms later.
  Readings<double> readings(long step, int run) const {
    const Misread then = fate.misread(step + run);
    Readings<double> out{false, triple(then.place), triple(then.velocity), {}, {}};
    for (int j = 0; j < kLongestPeriod; ++j) {
      const Misread now = fate.misread(step + j);
      out.turn[static_cast<std::size_t>(j)] = triple(now.turn);
      out.rates[static_cast<std::size_t>(j)] = triple(now.rates);
    }
    return out;
  }

  // The gust that comes up in the period that begins `step` ms after the first.
  Triple<double> gust(long step, int period) const {
    return triple((1 - kept) * fate.towards(step + period - 1));
  }

  // The largest difference of position (m), velocity (m/s) and rates (rad/s), n ms after the
  // trajectory's start, and a hundredth of that of angular acceleration (rad/s2).
  double off(long n, const Vec3& place, const Vec3& velocity, const Vec3& rates,
             const Vec3& spin) const {
    const auto at = static_cast<std::size_t>(n);
    return std::max({(place - flown.place[at]).norm(), (velocity - flown.velocity[at]).norm(),
                     (rates - flown.rates[at]).norm(), 0.01 * (spin - flown.spin[at]).norm()});
  }
};

// Exact readings and gains, or not: bounds of them for models, and any that are allowed for
// numbers.
class AnyReadings {
 public:
  AnyReadings(support::Random& random, bool exact, bool exact_gains) : random_(random) {
    const double share = std::pow(10, random.uniform(-4, 0));
    if (!exact_gains) noise_.gain_error = 0.3 * share;
    if (exact) return;
    noise_ = {.gain_error = noise_.gain_error,
              .place_noise = 0.03 * share,
              .velocity_noise = 0.1 * share,
              .attitude_noise = 0.05 * share,
              .rate_noise = 0.3 * share};
  }

  template <int N>
  Readings<TaylorModelOf<N>> of(const TaylorModelOf<N>&) const {
    return readings_within<TaylorModelOf<N>>(noise_);
  }
  Readings<double> of(double) const {
    const auto any = [&](double most) { return Triple<double>{one(most), one(most), one(most)}; };
    Readings<double> out{
        !noise_.has_noise(), any(noise_.place_noise), any(noise_.velocity_noise), {}, {}};
    for (Triple<double>& turn : out.turn) turn = any(noise_.attitude_noise);
    for (Triple<double>& rates : out.rates) rates = any(noise_.rate_noise);
    return out;
  }

  template <int N>
  GainErrors<TaylorModelOf<N>> gains(const TaylorModelOf<N>&) const {
    return gain_errors_within<TaylorModelOf<N>>(noise_);
  }
  GainErrors<double> gains(double) const {
    GainErrors<double> out;
    out.none = noise_.gain_error == 0;
    for_each(out, [&](double& share) { share = one(noise_.gain_error); });
    return out;
  }

 private:
  double one(double most) const {
    return most * (random_.uniform(0, 1) < 0.5 ? random_.uniform(-1, 1)
                                               : (random_.uniform(0, 1) < 0.5 ? -1 : 1));
  }

  support::Random& random_;
  Disturbances noise_ = {};
};

// How often values lay outside of what models say of them, and how often models said anything.
struct Held {
  int outside = 0;
  int bounded = 0;
};

// Coordinates added up with signs by chance, each as large as the others: symbols that several of
// them share must stand for one thing.
template <class Rows>
std::pair<typename Rows::Model, double> mixed(
    support::Random& random, typename Rows::template State<typename Rows::Model> state,
    const std::vector<double>& values) {
  std::pair<typename Rows::Model, double> out;
  for_each(state, [&](int i, const typename Rows::Model& m) {
    if (!std::isfinite(m.c) || !(m.radius() > 1e-12) || !std::isfinite(m.radius())) return;
    const double weight = (random.uniform(0, 1) < 0.5 ? -1 : 1) / m.radius();
    out.first = out.first + weight * m;
    out.second += weight * values[static_cast<std::size_t>(i)];
  });
  return out;
}

// Every state within a share of `sizes` around one whose lift is given and whose vehicle is as
// believed: a step of it is where the step of the model says. `look(after, there, holds)` calls
// holds(model, value) for what a step has beside its state.
template <class Rows, class StepOf, class Look>
void hold_steps(support::Random& random, std::span<const double> sizes, const Vec3& lift,
                const StepOf& step_of, const Look& look, Held& held) {
  using Model = typename Rows::Model;
  typename Rows::template State<Model> model;
  std::vector<double> middle, radius;
  const double share = std::pow(10, random.uniform(-4, 0));
  for_each(model, [&](int i, Model& m) {
    const double size = sizes[static_cast<std::size_t>(i)];
    const double c = i < 3 ? lift[i] : i >= Rows::kLightness ? 1 : random.uniform(-1, 1) * size;
    middle.push_back(c);
    radius.push_back(share * size);
    m = Model::symbol(c, i, radius.back());
  });
  auto after = step_of(model);
  for (int j = 0; j < 20; ++j) {
    typename Rows::template State<double> state;
    std::vector<double> s(Rows::kStates);
    for_each(state, [&](int i, double& v) {
      const auto at = static_cast<std::size_t>(i);
      s[at] = j % 2 ? random.uniform(-1, 1) : (random.uniform(0, 1) < 0.5 ? -1 : 1);
      v = middle[at] + radius[at] * s[at];
    });
    auto there = step_of(state);
    const auto holds = [&](const Model& m, double value) {
      double line = m.c;
      for (int i = 0; i < Rows::kStates; ++i) line += m.l[i] * s[static_cast<std::size_t>(i)];
      const double named = m.l.template tail<Model::kSymbols - Rows::kStates>().abs().sum();
      if (!std::isfinite(m.c) || !std::isfinite(m.radius())) return;
      held.outside += !(std::abs(value - line) <= named + m.r);
      ++held.bounded;
    };
    std::vector<double> values;
    for_each(there.state, [&](int, double v) { values.push_back(v); });
    for_each(after.state,
             [&](int i, const Model& m) { holds(m, values[static_cast<std::size_t>(i)]); });
    for (int k = 0; k < 4; ++k) {
      const auto [sum, value] = mixed<Rows>(random, after.state, values);
      holds(sum, value);
    }
    for (std::size_t n = 0; n < there.commands.size(); ++n) {
      for (std::size_t i = 0; i < 4; ++i) holds(after.commands[n][i], there.commands[n][i]);
      holds(after.moved[n].x, there.moved[n].x);
      holds(after.moved[n].y, there.moved[n].y);
      holds(after.moved[n].z, there.moved[n].z);
      holds(after.upright[n], there.upright[n]);
    }
    look(after, there, holds);
  }
}

}  // namespace traj::testing
