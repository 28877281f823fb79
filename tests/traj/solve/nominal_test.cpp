#include "solve/nominal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

TEST(NominalProfile, IsTheSmallestSpeedAndAccelerationOfTheLimits) {
  const SpeedProfile p = nominal_profile({{Limit::speed, 8},
                                          {Limit::horizontal_speed, 6},
                                          {Limit::vertical_speed, 7},
                                          {Limit::acceleration, 3},
                                          {Limit::thrust, kGravity + 4}},
                                         100);
  EXPECT_EQ(p.vmax, 6);
  EXPECT_EQ(p.amax, 3);
}

TEST(NominalProfile, KeepsTiltAndThrustInAnyDirection) {
  const double tilt = 0.5;
  EXPECT_NEAR(nominal_profile({{Limit::speed, 8}, {Limit::tilt, tilt}}, 100).amax,
              kGravity * std::sin(tilt), 1e-9);
  EXPECT_NEAR(nominal_profile({{Limit::speed, 8}, {Limit::thrust, kGravity + 2}}, 100).amax, 2,
              1e-12);
  const Limits both{{Limit::speed, 8}, {Limit::tilt, 0.05}, {Limit::thrust, 30}};
  EXPECT_NEAR(nominal_profile(both, 100).amax, kGravity * std::sin(0.05), 1e-9);
}

TEST(NominalProfile, FindsWhatIsMissingFromTheOther) {
  const SpeedProfile by_acceleration = nominal_profile({{Limit::acceleration, 4}}, 25);
  EXPECT_EQ(by_acceleration.vmax, 10) << "v^2 / (2 * 4) = 25 / 2";
  EXPECT_EQ(by_acceleration.amax, 4);
  const SpeedProfile by_speed = nominal_profile({{Limit::vertical_speed, 3}}, 25);
  EXPECT_EQ(by_speed.vmax, 3);
  EXPECT_EQ(by_speed.amax, 3) << "in a second";
  EXPECT_EQ(nominal_profile({}, 25).vmax, 10);
  EXPECT_EQ(nominal_profile({}, 25).amax, 10);
  EXPECT_GT(nominal_profile({{Limit::acceleration, 4}}, 0).vmax, 0) << "of a path of no length";
}

TEST(AlongLeg, TakesOfEachLimitItsShareOfTheDirection) {
  const Limits limits{{Limit::horizontal_speed, 10}, {Limit::vertical_speed, 5}};
  const SpeedProfile nominal = nominal_profile(limits, 100);
  EXPECT_EQ(along_leg({30, 40, 0}, limits, nominal).vmax, 10);
  EXPECT_EQ(along_leg({0, 0, -7}, limits, nominal).vmax, 5);
  EXPECT_DOUBLE_EQ(along_leg({4, 0, 3}, limits, nominal).vmax, 5 / 0.6) << "5 m/s upwards";
  EXPECT_DOUBLE_EQ(along_leg({4, 0, 1}, limits, nominal).vmax, 10 * std::hypot(4, 1) / 4);
  EXPECT_EQ(along_leg({30, 40, 0}, limits, nominal).amax, nominal.amax);
  Limits both = limits;
  both[Limit::speed] = 8;
  EXPECT_EQ(along_leg({30, 40, 0}, both, nominal).vmax, 8);
}

TEST(AlongLeg, HasTheProfileGivenWhereNothingLimitsTheSpeed) {
  const Limits limits{{Limit::acceleration, 4}};
  EXPECT_EQ(along_leg({1, 0, 0}, limits, nominal_profile(limits, 25)).vmax, 10);
  EXPECT_EQ(along_leg({1, 0, 0}, {{Limit::vertical_speed, 3}}, {3, 3}).vmax, 3);
  EXPECT_EQ(along_leg(Vec3::Zero(), {{Limit::speed, 8}}, {7, 3}).vmax, 7) << "of no length";
}

}  // namespace
}  // namespace traj
