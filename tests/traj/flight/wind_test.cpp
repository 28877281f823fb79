#include "traj/flight/wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace traj {
namespace {

using geom::Vec3;

TEST(DrydenScales, AreThoseOfTheStandard) {
  // At 200 feet with 30 knots at 20 feet, by hand: 0.177 + 0.1646 = 0.3416.
  const DrydenScales s = dryden_scales(200 * 0.3048, 15.433);
  EXPECT_NEAR(s.deviation.z(), 1.5433, 1e-12);
  EXPECT_NEAR(s.deviation.x(), 1.5433 / 0.65073, 1e-4);
  EXPECT_EQ(s.deviation.x(), s.deviation.y());
  EXPECT_NEAR(s.length.z(), 60.96, 1e-12);
  EXPECT_NEAR(s.length.x(), 60.96 / 0.27556, 2e-2);
  // At 1000 feet all lengths and deviations meet.
  const DrydenScales top = dryden_scales(304.8, 10);
  EXPECT_NEAR(top.length.x(), 304.8, 1e-9);
  EXPECT_NEAR(top.deviation.x(), 1, 1e-12);
  EXPECT_EQ(dryden_scales(5000, 10).length, top.length);
  EXPECT_EQ(dryden_scales(0, 10).length, dryden_scales(3.048, 10).length);
}

// Deviations, and correlations after the time of one scale length: e^-1 along the wind, and
// e^-1 (1 - 1/2) across it and up, as the transforms of the Dryden spectra.
TEST(Gusts, HaveTheDeviationsAndLengthsOfTheSpectra) {
  const double height = 60;
  const double speed = 20;
  const DrydenScales scales = dryden_scales(height, 12);
  Gusts gusts(12, 4);
  const double dt = 0.1;
  std::vector<Vec3> series(1000000);
  for (Vec3& v : series) v = gusts.step(height, speed, dt);
  for (int k = 0; k < 3; ++k) {
    const auto lag = static_cast<std::size_t>(std::lround(scales.length[k] / speed / dt));
    double sum = 0, square = 0, product = 0;
    for (std::size_t i = 0; i + lag < series.size(); ++i) {
      sum += series[i][k];
      square += series[i][k] * series[i][k];
      product += series[i][k] * series[i + lag][k];
    }
    const double n = static_cast<double>(series.size() - lag);
    const double variance = scales.deviation[k] * scales.deviation[k];
    const double x = static_cast<double>(lag) * dt * speed / scales.length[k];
    const double correlation = std::exp(-x) * (k == 0 ? 1 : 1 - x / 2);
    EXPECT_NEAR(sum / n, 0, 0.05 * scales.deviation[k]) << "axis " << k;
    EXPECT_NEAR(square / n, variance, 0.04 * variance) << "axis " << k;
    EXPECT_NEAR(product / square, correlation, 0.03) << "axis " << k;
  }
}

TEST(Gusts, AreStationaryFromTheFirstOn) {
  const DrydenScales scales = dryden_scales(50, 10);
  Vec3 square = Vec3::Zero();
  const int cases = 20000;
  for (int seed = 0; seed < cases; ++seed) {
    square += Gusts(10, seed).step(50, 5, 0.01).cwiseAbs2() / cases;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(square[k] / std::pow(scales.deviation[k], 2), 1, 0.05) << "axis " << k;
  }
}

TEST(Wind, IsItsMeanWithoutGustsAndAlongItWithThem) {
  Wind still({Vec3(3, 4, 1), 0}, 1);
  EXPECT_EQ(still.step(Vec3::Zero(), Vec3::Zero(), 0.01), Vec3(3, 4, 1));
  // The same seed: the same gusts, turned with the mean wind.
  Wind east({Vec3(5, 0, 0), 4}, 9);
  Wind north({Vec3(0, 5, 0), 4}, 9);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = east.step(Vec3(0, 0, 30), Vec3::Zero(), 0.01);
    const Vec3 b = north.step(Vec3(0, 0, 30), Vec3::Zero(), 0.01);
    EXPECT_LT((Vec3(-a.y(), a.x(), a.z()) - b).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace traj
