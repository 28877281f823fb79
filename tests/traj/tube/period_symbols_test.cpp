#include "tube/period_symbols.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "traj/flight/vehicle_profile.h"

namespace traj {
namespace {

Loop loop_of(std::string_view vehicle) {
  const auto profile = vehicle_named(vehicle);
  return {*quadrotor_of(profile->airframe), profile->airframe.gains->geometric, 4, 1, 0};
}

const ErrorVector& sizes() {
  static const ErrorVector out = [] {
    ErrorVector v = ErrorVector::Zero();
    v.head<kLoopStates>() << 0.3, 0.3, 0.3, 0.1, 0.1, 0.1, 0.2, 0.2, 0.2, 0.02, 0.2, 0.2, 0.2, 2, 2,
        1, 2, 2, 1, 2e-3, 2e-3, 1e-3, 0.5, 0.5, 0.5, 0.3, 0.3, 0.3, 0.02, 0.1, 0.05, 0.04, 0.05,
        0.06;
    return v;
  }();
  return out;
}

LoopState<double> numbers(const ErrorVector& v) {
  LoopState<double> out;
  for_each(out, [&](int i, double& x) { x = v[i]; });
  return out;
}

ErrorVector vector_of(LoopState<double> state) {
  ErrorVector out = ErrorVector::Zero();
  for_each(state, [&](int i, double x) { out[i] = x; });
  return out;
}

// Whatever deviates within the set is where the map and what is added say; without the named errors
// some would not be.
TEST(PeriodSymbols, MapEveryDeviation) {
  support::Random random(8);
  const LoopReferences references{
      {.acceleration = {1, 0.5, 0}, .jerk = {0.4, -0.2, 0.3}, .yaw = 0.7},
      {.acceleration = {1.01, 0.49, 0}, .yaw = 0.71}};
  int outside = 0;
  int named = 0;
  for (const std::string_view vehicle : {"quad2kg", "tello"}) {
    const Loop loop = loop_of(vehicle);
    for (int k = 0; k < 100; ++k) {
      const ErrorVector box = std::pow(10, random.uniform(-3, 0)) * sizes();
      const ErrorSet errors({}, box);
      ErrorVector middle = 0.5 * ErrorVector::Random().cwiseProduct(sizes());
      middle.head<3>() = Vec3(1, 0.5, 9.8);
      middle.tail<kErrorRows - kLightness>().setOnes();
      const PeriodSymbols symbols(loop.model, symbol_sizes(loop.model, errors));
      const PeriodMap period =
          symbols.map(loop_step(loop, symbols.state(middle), references).state);
      ASSERT_TRUE(period.finite());
      for (int j = 0; j < 20; ++j) {
        ErrorVector e;
        for (int i = 0; i < kErrorRows; ++i) {
          e[i] = box[i] * (j % 2 ? random.uniform(-1, 1) : (random.uniform(0, 1) < 0.5 ? -1 : 1));
        }
        const ErrorVector there =
            vector_of(loop_step(loop, numbers(middle + e), references).state) - period.middle -
            period.map * e;
        for (int i = 0; i < kWind; ++i) {
          const double left = std::abs(there[i]) - period.added.box[i];
          outside += left > period.added.named.row(i).cwiseAbs().sum();
          named += left > 0;
        }
      }
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(named, 100);
}

// A gust that comes up during a period moves the vehicle: all of it is in the remainder.
TEST(PeriodSymbols, KnowWhatGustsDoMeanwhile) {
  Loop loop = loop_of("quad2kg");
  loop.gust_most = 5;
  const ErrorSet errors({}, ErrorVector::Zero());
  ErrorVector middle = ErrorVector::Zero();
  middle[2] = 9.80665;
  middle.tail<kErrorRows - kLightness>().setOnes();
  const PeriodSymbols symbols(loop.model, symbol_sizes(loop.model, errors));
  const PeriodMap period = symbols.map(loop_step(loop, symbols.state(middle), {}).state);
  double moved = 0;
  for (int j = 0; j < 4; ++j)
    moved += 1e-3 * (1 - gust_kept(loop, j)) * 5 * loop.model.drag.x() / loop.model.mass;
  EXPECT_GE(period.added.box[kVelocity], 0.99 * moved);
  EXPECT_LE(period.added.box[kVelocity], 1.1 * moved);
}

TEST(PeriodSymbols, SayWhatIsNotFinite) {
  PeriodMap period;
  EXPECT_TRUE(period.finite());
  period.added.box[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(period.finite());
}

}  // namespace
}  // namespace traj
