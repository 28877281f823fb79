#include "tube/loop_step.h"

#include <gtest/gtest.h>

#include "traj/curve/yaw.h"
#include "traj/disturbed_flight.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/flights.h"

namespace traj {
namespace {

constexpr double kGravity = 9.80665;

Loop loop_of(const FlightOptions& options) {
  return {options.quadrotor, options.gains.geometric, options.periods.attitude, 1, 0};
}

FlightOptions flight_of(std::string_view vehicle) {
  const auto profile = vehicle_named(vehicle);
  FlightOptions options{.quadrotor = *quadrotor_of(profile->airframe)};
  options.gains = *profile->airframe.gains;
  options.law = ControlLaw::geometric;
  return options;
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

LoopState<double> numbers(LoopState<TaylorModel> state) {
  LoopState<double> out;
  std::vector<double> values;
  for_each(state, [&](int, const TaylorModel& m) { values.push_back(m.c); });
  for_each(out, [&](int i, double& v) { v = values[static_cast<std::size_t>(i)]; });
  return out;
}

// The largest difference of position or velocity from the simulator's, at any step of the attitude
// loop.
double disagreement(const FlightOptions& options, double yaw, double mass_error,
                    std::uint64_t seed) {
  const ReferenceTrack track(bend(yaw));
  const Loop loop = loop_of(options);
  support::Random random(seed);
  const Vec3 wind(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.3));
  const Vec3 push = 0.3 * testing::direction(random);
  // The gust runs up in the first step of a period at most, so that the equations know it whole.
  const double kept = std::exp(-kStep);
  const auto towards = [&](long n) {
    return n % 4 == 3 ? Vec3(push * std::sin(0.01 * static_cast<double>(n)) / (1 - kept) * 0.02)
                      : Vec3::Zero();
  };
  testing::Fate fate{.wind = wind, .mass_error = mass_error, .towards = towards};
  fate.drag_error = 3 * mass_error;
  fate.motor_lag_error = -mass_error;
  fate.inertia_error = mass_error * Vec3(1, -1, 2);
  const auto flown = testing::fly(track, options, {}, fate);
  EXPECT_FALSE(flown.saturated);

  std::size_t cursor = 0;
  const long before = std::lround(options.hover / kStep);
  LoopState<double> s = numbers(resting(1 / (1 + mass_error)));
  s.wind = triple(wind);
  s.drag = 1 + fate.drag_error;
  s.quickness = 1 / (1 + fate.motor_lag_error);
  s.agility = triple((Vec3::Ones() + fate.inertia_error).cwiseInverse());
  double worst = 0;
  const long steps = std::lround((track.duration() + options.settle) / kStep);
  Reference now = track.at(-options.hover, cursor);
  for (long n = -before; n <= steps; n += 4) {
    if (n >= 0) {
      const auto at = static_cast<std::size_t>(n);
      const Vec3 velocity(s.velocity.x, s.velocity.y, s.velocity.z);
      const Vec3 asked = Vec3(s.lift.x, s.lift.y, s.lift.z - kGravity) - now.acceleration;
      const Vec3 off = -(asked - loop.gains.velocity.cwiseProduct(now.velocity - velocity))
                            .cwiseQuotient(loop.gains.position);
      worst =
          std::max({worst, (off - flown.place[at]).norm(), (velocity - flown.velocity[at]).norm()});
    }
    const Reference next = track.at(static_cast<double>(n + 4) * kStep, cursor);
    s = loop_step(loop, s, {now, next}).state;
    const Vec3 gust = (1 - kept) * towards(n + before + 3);
    s.gust = s.gust + triple(gust);
    now = next;
  }
  return worst;
}

TEST(LoopStep, IsWhatTheSimulatorDoes) {
  for (const std::string_view vehicle : {"quad2kg", "crazyflie", "tello"}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const double yaw = static_cast<double>(seed) * 1.4 - 2;
      EXPECT_LT(disagreement(flight_of(vehicle), yaw, 0.02 * static_cast<double>(seed), seed), 1e-9)
          << vehicle << " " << seed;
    }
  }
}

// Every state within the radii is mapped to what the models say.
TEST(LoopStep, BoundsEveryStep) {
  support::Random random(5);
  const FlightOptions options = flight_of("tello");  // drag and inertia differ by axis
  const Loop loop = loop_of(options);
  const ReferenceTrack track(bend(0.4));
  const double sizes[] = {0.3, 0.3, 0.3, 0.1, 0.1,  0.1, 0.2,  0.2,  0.2,  0.02, 0.2, 0.2,
                          0.2, 2,   2,   1,   2,    2,   1,    2e-3, 2e-3, 1e-3, 0.5, 0.5,
                          0.5, 0.3, 0.3, 0.3, 0.02, 0.1, 0.05, 0.04, 0.05, 0.06};
  int outside = 0;
  int bounded = 0;
  for (int k = 0; k < 300; ++k) {
    std::size_t cursor = 0;
    const double t = random.uniform(0, 10);
    const LoopReferences references{track.at(t, cursor), track.at(t + 4 * kStep, cursor)};
    LoopState<TaylorModel> model;
    std::vector<double> middle, radius;
    const double share = std::pow(10, random.uniform(-4, 0));
    const Vec3 lift = references.now.acceleration + kGravity * Vec3::UnitZ();
    for_each(model, [&](int i, TaylorModel& m) {
      const double c = i < 3 ? lift[i] : i >= 28 ? 1 : random.uniform(-1, 1) * sizes[i];
      middle.push_back(c);
      radius.push_back(share * sizes[i]);
      m = TaylorModel::symbol(c, i, radius.back());
    });
    auto after = loop_step(loop, model, references);
    for (int j = 0; j < 20; ++j) {
      LoopState<double> state;
      std::vector<double> s(kLoopStates);
      for_each(state, [&](int i, double& v) {
        const auto at = static_cast<std::size_t>(i);
        s[at] = j % 2 ? random.uniform(-1, 1) : (random.uniform(0, 1) < 0.5 ? -1 : 1);
        v = middle[at] + radius[at] * s[at];
      });
      auto there = loop_step(loop, state, references);
      const auto holds = [&](const TaylorModel& m, double value) {
        double line = m.c;
        for (int i = 0; i < kLoopStates; ++i) line += m.l[i] * s[static_cast<std::size_t>(i)];
        const double named = m.l.tail<TaylorModel::kSymbols - kLoopStates>().abs().sum();
        outside += !(std::abs(value - line) <= named + m.r);
        bounded += std::isfinite(m.r);
      };
      std::vector<double> values;
      for_each(there.state, [&](int, double v) { values.push_back(v); });
      for_each(after.state,
               [&](int i, const TaylorModel& m) { holds(m, values[static_cast<std::size_t>(i)]); });
      for (std::size_t n = 0; n < there.commands.size(); ++n) {
        for (std::size_t i = 0; i < 4; ++i) holds(after.commands[n][i], there.commands[n][i]);
        holds(after.moved[n].x, there.moved[n].x);
        holds(after.moved[n].z, there.moved[n].z);
      }
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(bounded, 200000) << "a bound that is infinite says nothing";
}

TEST(LoopStep, HasNoBoundForAThrustThatMayPointDown) {
  const FlightOptions options = flight_of("quad2kg");
  LoopState<TaylorModel> state = resting(1);
  state.lift.z = TaylorModel::symbol(kGravity, 2, 10);
  const auto step = loop_step(loop_of(options), state, {});
  EXPECT_FALSE(std::isfinite(step.state.velocity.x.radius()));
}

TEST(LoopStep, KeepsAShareOfAGust) {
  Loop loop = loop_of(flight_of("quad2kg"));
  loop.gust_lag = 2;
  EXPECT_DOUBLE_EQ(gust_kept(loop, 4), std::exp(-0.002));
}

}  // namespace
}  // namespace traj
