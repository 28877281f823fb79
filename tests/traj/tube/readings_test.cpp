#include "tube/readings.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

using geom::Vec3;

double sign(support::Random& random) { return random.uniform(0, 1) < 0.5 ? -1 : 1; }

TEST(Readings, AreExactWithoutNoise) {
  EXPECT_TRUE(readings_within<TaylorModel>({.gust_most = 1}).exact);
  for (const auto one : {&Disturbances::place_noise, &Disturbances::velocity_noise,
                         &Disturbances::attitude_noise, &Disturbances::rate_noise}) {
    Disturbances d;
    d.*one = 1e-9;
    EXPECT_FALSE(readings_within<TaylorModel>(d).exact);
  }
}

TEST(Readings, TurnAxesAsAQuaternionDoes) {
  support::Random random(3);
  for (int k = 0; k < 100; ++k) {
    const auto any = [&] {
      return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const Vec3 v = any();
    const Vec3 half = 0.5 * any();
    const Eigen::Quaterniond is =
        Eigen::Quaterniond(random.uniform(-1, 1), v.x(), v.y(), v.z()).normalized();
    const Eigen::Quaterniond seen =
        (is * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
    Frame<double> frame{};
    frame.x = triple(Vec3(is * Vec3::UnitX()));
    frame.y = triple(Vec3(is * Vec3::UnitY()));
    frame.z = triple(Vec3(is * Vec3::UnitZ()));
    const Frame<double> off = misread(frame, triple(Vec3(2 * half)));
    const auto expect_off = [&](const Triple<double>& axis, const Vec3& unit) {
      const Vec3 expected = seen * unit - is * unit;
      EXPECT_LT((Vec3(axis.x, axis.y, axis.z) - expected).norm(), 1e-14);
    };
    expect_off(off.x, Vec3::UnitX());
    expect_off(off.y, Vec3::UnitY());
    expect_off(off.z, Vec3::UnitZ());
  }
}

// The error that noise made is a symbol. For each value of the noise and of the rest, the noise is
// where the symbol of that error says.
TEST(Readings, AreRetoldByTheErrorThatTheyMade) {
  support::Random random(5);
  int tied = 0;
  for (int k = 0; k < 2000; ++k) {
    const double most = std::pow(10, random.uniform(-6, 0));
    const double gain = std::pow(10, random.uniform(-1, 2));
    const double rest = gain * most * std::pow(10, random.uniform(-6, 0.3));
    const TaylorModel noise = TaylorModel::within(0, most);
    const TaylorModel error = (TaylorModel::within(0, rest) - gain * noise).named(kLoopStates + 1);
    const Triple<TaylorModel> out =
        retold(Triple<TaylorModel>{{}, noise, {}}, Triple<TaylorModel>{{}, error, {}},
               Vec3(1, gain, 1), kLoopStates);
    const TaylorModel& told = out.y;
    tied += told.l[kLoopStates + 1] != 0;
    for (int j = 0; j < 20; ++j) {
      const double value = most * (j % 2 ? sign(random) : random.uniform(-1, 1));
      const double more = rest * (j % 4 < 2 ? sign(random) : random.uniform(-1, 1));
      const double symbol = (more - gain * value) / error.l[kLoopStates + 1];
      ASSERT_LE(std::abs(symbol), 1);
      ASSERT_LE(std::abs(value - told.c - told.l[kLoopStates + 1] * symbol), told.r)
          << most << " " << gain << " " << rest;
    }
  }
  EXPECT_GT(tied, 1000);
  EXPECT_LT(tied, 2000) << "noise that is hardly a part of the error is not tied to it";
}

}  // namespace
}  // namespace traj
