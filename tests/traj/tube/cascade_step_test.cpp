#include "tube/cascade_step.h"

#include <gtest/gtest.h>

#include "traj/disturbed_flight.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/flights.h"

namespace traj {
namespace {

constexpr double kGravity = 9.80665;
using Model = CascadeRows::Model;

FlightOptions flight_of(std::string_view vehicle) {
  const auto profile = vehicle_named(vehicle);
  FlightOptions options{.quadrotor = *quadrotor_of(profile->airframe)};
  options.gains = *profile->airframe.gains;
  return options;
}

CascadeLoop loop_of(const FlightOptions& options) {
  return {options.quadrotor, options.gains, options.periods, {1, 0}};
}

// A bend that climbs, with a heading that turns.
Trajectory bend(double yaw) {
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

CascadeState<double> numbers(CascadeState<Model> state) {
  CascadeState<double> out;
  std::vector<double> values;
  for_each(state, [&](int, const Model& m) { values.push_back(m.c); });
  for_each(out, [&](int i, double& v) { v = values[static_cast<std::size_t>(i)]; });
  return out;
}

// The references of the period that begins at step n, the controller's first run being at -before.
CascadeReferences references_of(const ReferenceTrack& track, const FlightOptions& options, long n,
                                long before) {
  std::size_t cursor = 0;
  CascadeReferences out;
  out.step = n + before;
  for (int j = 0; j <= options.periods.attitude; ++j) {
    out.at.push_back(track.at(static_cast<double>(n + j) * kStep, cursor));
  }
  const long last = (out.step + options.periods.position - 1) / options.periods.position - 1;
  if (last >= 0) {
    cursor = 0;
    out.last_asked =
        track.at(static_cast<double>(last * options.periods.position - before) * kStep, cursor)
            .acceleration;
  }
  return out;
}

Vec3 vector(const Triple<double>& t) { return {t.x, t.y, t.z}; }

// kp (p_r - p) + f v_r - v.
Vec3 velocity_error(const CascadeLoop& loop, const CascadeState<double>& s) {
  const LiftGains k(loop);
  const Vec3 drift = (vector(s.due) - k.of_missed.cwiseProduct(vector(s.missed)) +
                      k.of_slope.cwiseProduct(vector(s.slope)))
                         .cwiseQuotient(k.of_drift);
  return vector(s.missed) + drift;
}

// The largest difference of position or velocity from the simulator's, at any step of the attitude
// loop.
double disagreement(const FlightOptions& options, double yaw, double mass_error,
                    std::uint64_t seed) {
  const ReferenceTrack track(bend(yaw));
  const CascadeLoop loop = loop_of(options);
  support::Random random(seed);
  const Vec3 wind(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.3));
  const Vec3 push = 0.3 * testing::direction(random);
  const int period = options.periods.attitude;
  // The gust runs up in the first step of a period at most, so that the equations know it whole.
  const double kept = std::exp(-kStep);
  const auto towards = [&](long n) {
    return n % period == period - 1
               ? Vec3(push * std::sin(0.01 * static_cast<double>(n)) / (1 - kept) * 0.02)
               : Vec3::Zero();
  };
  testing::Fate fate{.wind = wind, .mass_error = mass_error, .towards = towards};
  fate.drag_error = 3 * mass_error;
  fate.motor_lag_error = -mass_error;
  fate.inertia_error = mass_error * Vec3(1, -1, 2);
  const auto flown = testing::fly(track, options, {}, fate);
  EXPECT_FALSE(flown.saturated);

  const long before = std::lround(options.hover / kStep);
  CascadeState<double> s = numbers(cascade_at_rest(1 / (1 + mass_error)));
  s.wind = triple(wind);
  s.drag = 1 + fate.drag_error;
  s.quickness = 1 / (1 + fate.motor_lag_error);
  s.agility = triple((Vec3::Ones() + fate.inertia_error).cwiseInverse());
  double worst = 0;
  const long steps = std::lround((track.duration() + options.settle) / kStep);
  for (long n = -before; n <= steps; n += period) {
    const CascadeReferences references = references_of(track, options, n, before);
    const Reference& now = references.at[0];
    if (n >= 0) {
      const auto at = static_cast<std::size_t>(n);
      const Vec3 velocity(s.velocity.x, s.velocity.y, s.velocity.z);
      const Vec3 missed = velocity_error(loop, s);
      const Vec3 off = -(missed + velocity - options.gains.feed_forward.velocity * now.velocity)
                            .cwiseQuotient(options.gains.position.p);
      worst =
          std::max({worst, (off - flown.place[at]).norm(), (velocity - flown.velocity[at]).norm()});
    }
    s = cascade_step(loop, s, references).state;
    const Vec3 gust = (1 - kept) * towards(n + before + period - 1);
    s.gust = s.gust + triple(gust);
  }
  return worst;
}

TEST(CascadeStep, IsWhatTheSimulatorDoes) {
  for (const std::string_view vehicle : {"quad2kg", "crazyflie", "tello"}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      FlightOptions options = flight_of(vehicle);
      if (seed == 1) options.periods = {4, 4};
      if (seed == 2) options.periods = {7, 3};
      if (seed == 3) options.gains.feed_forward = {0.9, 0.5, 0};
      const double yaw = static_cast<double>(seed) * 1.4 - 2;
      EXPECT_LT(disagreement(options, yaw, 0.02 * static_cast<double>(seed), seed), 1e-9)
          << vehicle << " " << seed;
    }
  }
}

// Every state within the radii is mapped to what the models say.
TEST(CascadeStep, BoundsEveryStep) {
  support::Random random(5);
  const FlightOptions options = flight_of("tello");  // drag and inertia differ by axis
  const CascadeLoop loop = loop_of(options);
  const ReferenceTrack track(bend(0.4));
  const double sizes[CascadeRows::kStates] = {
      0.3,  0.3, 0.3, 0.1, 0.1, 0.1, 0.02, 0.02, 0.2, 0.02, 0.2,  0.2,  0.2, 2,    2,
      1,    2,   2,   1,   1,   1,   0.5,  0.2,  0.2, 0.2,  0.2,  0.2,  0.2, 0.02, 0.02,
      0.02, 0.5, 0.5, 0.5, 0.3, 0.3, 0.3,  0.02, 0.1, 0.05, 0.04, 0.05, 0.06};
  int outside = 0;
  int bounded = 0;
  for (int k = 0; k < 200; ++k) {
    const CascadeReferences references = references_of(
        track, options, 4 * static_cast<long>(random.below(2400)), 4 * random.below(9));
    CascadeState<Model> model;
    std::vector<double> middle, radius;
    const double share = std::pow(10, random.uniform(-4, 0));
    const Vec3 lift = references.at[0].acceleration + kGravity * Vec3::UnitZ();
    for_each(model, [&](int i, Model& m) {
      const double c = i < 3                          ? lift[i]
                       : i >= CascadeRows::kLightness ? 1
                                                      : random.uniform(-1, 1) * sizes[i];
      middle.push_back(c);
      radius.push_back(share * sizes[i]);
      m = Model::symbol(c, i, radius.back());
    });
    auto after = cascade_step(loop, model, references);
    for (int j = 0; j < 20; ++j) {
      CascadeState<double> state;
      std::vector<double> s(CascadeRows::kStates);
      for_each(state, [&](int i, double& v) {
        const auto at = static_cast<std::size_t>(i);
        s[at] = j % 2 ? random.uniform(-1, 1) : (random.uniform(0, 1) < 0.5 ? -1 : 1);
        v = middle[at] + radius[at] * s[at];
      });
      auto there = cascade_step(loop, state, references);
      const auto holds = [&](const Model& m, double value) {
        double line = m.c;
        for (int i = 0; i < CascadeRows::kStates; ++i) {
          line += m.l[i] * s[static_cast<std::size_t>(i)];
        }
        const double named = m.l.tail<Model::kSymbols - CascadeRows::kStates>().abs().sum();
        outside += !(std::abs(value - line) <= named + m.r);
        bounded += std::isfinite(m.r);
      };
      const auto all_hold = [&](const Triple<Model>& m, const Triple<double>& value) {
        holds(m.x, value.x), holds(m.y, value.y), holds(m.z, value.z);
      };
      std::vector<double> values;
      for_each(there.state, [&](int, double v) { values.push_back(v); });
      for_each(after.state,
               [&](int i, const Model& m) { holds(m, values[static_cast<std::size_t>(i)]); });
      for (std::size_t n = 0; n < there.commands.size(); ++n) {
        for (std::size_t i = 0; i < 4; ++i) holds(after.commands[n][i], there.commands[n][i]);
        all_hold(after.moved[n], there.moved[n]);
        holds(after.upright[n], there.upright[n]);
      }
      all_hold(after.rates, there.rates);
      for (std::size_t n = 0; n < there.runs.size(); ++n) {
        all_hold(after.runs[n].velocity, there.runs[n].velocity);
        all_hold(after.runs[n].before, there.runs[n].before);
        all_hold(after.runs[n].acceleration, there.runs[n].acceleration);
        all_hold(after.runs[n].lift, there.runs[n].lift);
      }
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(bounded, 200000) << "a bound that is infinite says nothing";
}

TEST(CascadeStep, HasNoBoundForAThrustThatMayPointDown) {
  const FlightOptions options = flight_of("quad2kg");
  CascadeState<Model> state = cascade_at_rest(1);
  state.lift.z = Model::symbol(kGravity, 2, 10);
  const auto step = cascade_step(loop_of(options), state, {.at = std::vector<Reference>(5)});
  EXPECT_FALSE(std::isfinite(step.state.velocity.x.radius()));
}

}  // namespace
}  // namespace traj
