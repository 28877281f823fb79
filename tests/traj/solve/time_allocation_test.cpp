#include "solve/time_allocation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace traj {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<Vec3> kCorner{Vec3::Zero(), Vec3(4, 0, 0), Vec3(4, 2, 0)};

TEST(LegTime, IsATrapezoidWhereTheLegIsLongEnough) {
  // 4 s to 8 m/s over 16 m, 10 m at 8 m/s, 4 s to rest.
  EXPECT_DOUBLE_EQ(leg_time(42, 0, 0, {8, 2}), 4 + 10.0 / 8 + 4);
}

TEST(LegTime, IsATriangleWhereItIsNot) {
  EXPECT_DOUBLE_EQ(leg_time(8, 0, 0, {8, 2}), 2 * std::sqrt(8 / 2.0));
}

TEST(LegTime, GoesBetweenGivenSpeeds) { EXPECT_DOUBLE_EQ(leg_time(6, 2, 4, {4, 1}), 2); }

TEST(StoppingTimes, AreOneLegTimeEach) {
  const SpeedProfile profile{3, 1};
  EXPECT_EQ(stopping_times(kCorner, profile),
            (std::vector<double>{leg_time(4, 0, 0, profile), leg_time(2, 0, 0, profile)}));
}

TEST(EvenTimes, AreLengthOverSpeed) {
  EXPECT_EQ(even_times(kCorner, 0.5), (std::vector<double>{8, 4}));
  EXPECT_TRUE(even_times(std::vector<Vec3>{Vec3::Zero()}, 1).empty());
}

TEST(TurnRadii, TouchBothLegsHalfTheShorterOneAway) {
  EXPECT_EQ(turn_radii(kCorner), (std::vector<double>{kInfinity, 1, kInfinity}));
  // An inscribed circle of a regular hexagon of side 2.
  const std::vector<Vec3> hexagon{Vec3(2, 0, 0), Vec3(1, std::sqrt(3), 0),
                                  Vec3(-1, std::sqrt(3), 0)};
  EXPECT_NEAR(turn_radii(hexagon)[1], std::sqrt(3), 1e-14);
}

TEST(TurnRadii, AreInfiniteStraightOnAndZeroBackwards) {
  const std::vector<Vec3> points{Vec3::Zero(), Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3::Zero()};
  EXPECT_EQ(turn_radii(points), (std::vector<double>{kInfinity, kInfinity, 0, kInfinity}));
}

TEST(CautiousTimes, CruiseWhereNothingIsNear) {
  const std::vector<Vec3> straight{Vec3::Zero(), Vec3(4, 0, 0), Vec3(6, 0, 0)};
  EXPECT_EQ(cautious_times(straight, std::vector<double>{9, 9}, {2, 1, 1, 0.1}),
            (std::vector<double>{2, 1}));
}

TEST(CautiousTimes, AreSlowerNearTurnsAndObstacles) {
  const Caution caution{10, 4, 2, 0.1};
  // Radius 1 at 4 m/s2: 2 m/s; the second leg at a quarter of the comfortable distance.
  EXPECT_EQ(cautious_times(kCorner, std::vector<double>{2, 0.5}, {10, 4, 2, 0.01}),
            (std::vector<double>{2, 4}));
  // Never below a tenth of the cruise: 1 m/s.
  EXPECT_EQ(cautious_times(kCorner, std::vector<double>{0, 0}, caution),
            (std::vector<double>{4, 2}));
}

TEST(CautiousTimes, AreZeroForLegsOfNoLength) {
  const std::vector<Vec3> points(2, Vec3(1, 2, 3));
  EXPECT_EQ(cautious_times(points, std::vector<double>{0}, {}), std::vector<double>{0});
}

TEST(CornerSpeeds, PassForwardAndBackwardFromRest) {
  const std::vector<Vec3> straight{Vec3::Zero(), Vec3(2, 0, 0), Vec3(50, 0, 0), Vec3(50.5, 0, 0)};
  const std::vector<SpeedProfile> legs(3, {5, 1});
  const auto speeds = corner_speeds(straight, legs, {1, 1});
  EXPECT_EQ(speeds, (std::vector<double>{0, 2, 1, 0}));
  const auto times = rolling_times(straight, speeds, legs);
  EXPECT_DOUBLE_EQ(times[0], 2);
  EXPECT_DOUBLE_EQ(times[1], 3 + (48 - 10.5 - 12) / 5 + 4);
  EXPECT_DOUBLE_EQ(times[2], 1);
}

// The deviation would allow more than an arc that begins half the short leg away.
TEST(CornerSpeeds, KeepToTheProfileOfEachLeg) {
  const std::vector<Vec3> straight{Vec3::Zero(), Vec3(20, 0, 0), Vec3(40, 0, 0), Vec3(60, 0, 0)};
  const std::vector<SpeedProfile> legs{{5, 2}, {3, 2}, {6, 2}};
  const auto speeds = corner_speeds(straight, legs, {1, 1});
  EXPECT_EQ(speeds, (std::vector<double>{0, 3, 3, 0})) << "of two legs the slower";
  const auto times = rolling_times(straight, speeds, legs);
  EXPECT_DOUBLE_EQ(times[0], 2.5 + 1 + (20 - 6.25 - 4) / 5) << "up to 5 m/s, down to 3 m/s";
  EXPECT_DOUBLE_EQ(times[1], 20 / 3.0);
}

TEST(CornerSpeeds, RoundACornerOfAShortLegWithinTheLeg) {
  const Turns turns{2, 0.5};
  Turns within = turns;
  within.within_legs = true;
  const std::vector<Vec3> corner{Vec3::Zero(), Vec3(100, 0, 0), Vec3(100, 0.2, 0),
                                 Vec3(200, 0.2, 0)};
  const std::vector<SpeedProfile> legs(3, {50, 2});
  EXPECT_NEAR(corner_speeds(corner, legs, within)[1], std::sqrt(2 * 0.1), 1e-12);
  EXPECT_GT(corner_speeds(corner, legs, turns)[1], 1);
}

TEST(CornerSpeeds, RoundARightAngleWithinTheDeviation) {
  const std::vector<Vec3> corner{Vec3::Zero(), Vec3(100, 0, 0), Vec3(100, 100, 0)};
  const double s = std::sqrt(0.5);
  const std::vector<SpeedProfile> legs(2, {50, 2});
  EXPECT_NEAR(corner_speeds(corner, legs, {2, 0.5})[1], std::sqrt(2 * 0.5 * s / (1 - s)), 1e-12);
}

}  // namespace
}  // namespace traj
