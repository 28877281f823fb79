#include "traj/flight/noise.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Gaussian, HasTheMomentsOfTheNormalDistribution) {
  Gaussian noise(1);
  const int count = 400000;
  double moment[5] = {};
  int beyond = 0;  // two deviations: a share of 0.0455
  for (int i = 0; i < count; ++i) {
    const double x = noise.next();
    double power = 1;
    for (double& m : moment) {
      m += power / count;
      power *= x;
    }
    beyond += std::abs(x) > 2;
  }
  EXPECT_NEAR(moment[1], 0, 0.01);
  EXPECT_NEAR(moment[2], 1, 0.01);
  EXPECT_NEAR(moment[3], 0, 0.03);
  EXPECT_NEAR(moment[4], 3, 0.06);
  EXPECT_NEAR(beyond / static_cast<double>(count), 0.0455, 0.002);
}

TEST(Gaussian, NeighboursAreNotCorrelated) {
  Gaussian noise(2);
  double last = noise.next();
  double product = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = noise.next();
    product += x * last / 200000;
    last = x;
  }
  EXPECT_NEAR(product, 0, 0.01);
}

TEST(Gaussian, IsTheSameForASeedAndAVectorIsTheNextThree) {
  Gaussian a(3);
  Gaussian b(3);
  Gaussian c(4);
  const geom::Vec3 v = a.vector();
  for (int k = 0; k < 3; ++k) EXPECT_EQ(v[k], b.next());
  EXPECT_NE(c.next(), v[0]);
}

}  // namespace
}  // namespace traj
