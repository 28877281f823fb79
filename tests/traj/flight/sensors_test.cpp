#include "traj/flight/sensors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

TEST(Sensors, AreLateByTheirDelay) {
  SensorSpec spec;
  spec.delay = 0.003;
  QuadrotorState state;
  Sensors sensors(spec, state, 0);
  for (int n = 0; n < 10; ++n) {
    state.position.x() = n;
    state.body_rates.x() = n;
    const Measured seen = sensors.read(state);
    EXPECT_EQ(seen.position.x(), std::max(0, n - 3));
    EXPECT_EQ(seen.body_rates.x(), n);
  }
}

TEST(Sensors, HaveTheDeviationsAskedFor) {
  SensorSpec spec{0.1, 0.2, 0.01, 0.3, 0};
  QuadrotorState state;
  state.attitude = Eigen::AngleAxisd(0.5, Vec3::UnitY());
  Sensors sensors(spec, state, 3);
  Eigen::Vector4d square = Eigen::Vector4d::Zero();
  const int n = 40000;
  for (int i = 0; i < n; ++i) {
    const Measured m = sensors.read(state);
    square += Eigen::Vector4d(m.position.squaredNorm(), m.velocity.squaredNorm(),
                              std::pow(m.attitude.angularDistance(state.attitude), 2),
                              m.body_rates.squaredNorm()) /
              (3.0 * n);
  }
  EXPECT_NEAR(square[0], 0.01, 3e-4);
  EXPECT_NEAR(square[1], 0.04, 1.2e-3);
  EXPECT_NEAR(square[2], 1e-4, 3e-6);
  EXPECT_NEAR(square[3], 0.09, 2.7e-3);
}

}  // namespace
}  // namespace traj
