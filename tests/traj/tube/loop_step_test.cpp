#include "tube/loop_step.h"

#include <gtest/gtest.h>

#include "step_case.h"

namespace traj {
namespace {

using testing::flight_of;

constexpr double kGravity = 9.80665;

Loop loop_of(const FlightOptions& options) {
  return {options.quadrotor, options.gains.geometric, options.periods.attitude, 1, 0};
}

// The largest difference from the simulator's flight, at any step of the attitude loop.
double disagreement(const FlightOptions& options, double yaw, double error, std::uint64_t seed) {
  const ReferenceTrack track(testing::bend(yaw));
  const Loop loop = loop_of(options);
  const testing::OddFlight flight(track, options, error, seed);
  std::size_t cursor = 0;
  const long before = std::lround(options.hover / kStep);
  LoopState<double> s = testing::numbers<GeometricRows>(
      starting(loop, 1 / (1 + error), track.at(-options.hover, cursor), flight.off<TaylorModel>()));
  flight.set(s);
  double worst = 0;
  const long steps = std::lround((track.duration() + options.settle) / kStep);
  Reference now = track.at(-options.hover, cursor);
  for (long n = -before; n <= steps; n += 4) {
    if (n >= 0) {
      const Vec3 velocity = testing::vector(s.velocity);
      const Vec3 asked = testing::vector(s.lift) - kGravity * Vec3::UnitZ() - now.acceleration;
      const Vec3 off = -(asked - loop.gains.velocity.cwiseProduct(now.velocity - velocity))
                            .cwiseQuotient(loop.gains.position);
      worst = std::max(
          worst, flight.off(n, off, velocity, testing::vector(s.rates), testing::vector(s.spin)));
    }
    const Reference next = track.at(static_cast<double>(n + 4) * kStep, cursor);
    s = loop_step(loop, s, {now, next}, flight.readings(n + before, 0), flight.gains).state;
    s.gust = s.gust + flight.gust(n + before, 4);
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
  const Loop loop = loop_of(flight_of("tello"));  // drag and inertia differ by axis
  const ReferenceTrack track(testing::bend(0.4));
  const double sizes[] = {0.3, 0.3, 0.3, 0.1, 0.1,  0.1, 0.2,  0.2,  0.2,  0.02, 0.2, 0.2,
                          0.2, 2,   2,   1,   2,    2,   1,    2e-3, 2e-3, 1e-3, 0.5, 0.5,
                          0.5, 0.3, 0.3, 0.3, 0.02, 0.1, 0.05, 0.04, 0.05, 0.06};
  testing::Held held;
  for (int k = 0; k < 300; ++k) {
    std::size_t cursor = 0;
    const double t = random.uniform(0, 10);
    const LoopReferences references{track.at(t, cursor), track.at(t + 4 * kStep, cursor)};
    const Vec3 lift = references.now.acceleration + kGravity * Vec3::UnitZ();
    const testing::AnyReadings read(random, k % 2 == 0, k % 4 < 2);
    const auto step_of = [&](const auto& state) {
      return loop_step(loop, state, references, read.of(state.velocity.x),
                       read.gains(state.velocity.x));
    };
    testing::hold_steps<GeometricRows>(
        random, sizes, lift, step_of, [](const auto&, const auto&, const auto&) {}, held);
  }
  EXPECT_EQ(held.outside, 0);
  EXPECT_GT(held.bounded, 200000) << "a bound that is infinite says nothing";
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
