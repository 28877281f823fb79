#include "flight/attitude.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(Attitude, ErrorIsTheRotationThatIsLeft) {
  const Eigen::Quaterniond now(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  const Eigen::Quaterniond tilted = now * Eigen::AngleAxisd(0.01, Vec3(0.6, 0.8, 0));
  EXPECT_LT((attitude_error(now, tilted, 0.4) - Vec3(0.006, 0.008, 0)).norm(), 1e-6);
  const Eigen::Quaterniond turned = now * Eigen::AngleAxisd(0.01, Vec3::UnitZ());
  EXPECT_LT((attitude_error(now, turned, 0.4) - Vec3(0, 0, 0.004)).norm(), 1e-6);
  EXPECT_LT((attitude_error(now, turned, 1) - Vec3(0, 0, 0.01)).norm(), 1e-6);
  Eigen::Quaterniond same = now;
  same.coeffs() *= -1;
  EXPECT_LT(attitude_error(now, same, 1).norm(), 1e-12);
}

}  // namespace
}  // namespace traj
