#include "mission/mavlink/mission_corners.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

constexpr Turn kRest{};

Turn pass(double radius) { return {Turn::pass, radius, radius}; }

const std::vector<FlightPart> kLegs = {
    {1, Manoeuvre::takeoff}, {2, Manoeuvre::leg}, {3, Manoeuvre::leg}, {4, Manoeuvre::leg}};

TEST(CornersOf, AreOfPointsThatArePassed) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 50, 9}, {0, 50, 9}};
  const Corners corners =
      corners_of(path, std::vector<Turn>{kRest, pass(5), kRest, kRest}, kLegs, 7);
  EXPECT_EQ(corners.count, 1u);
  EXPECT_EQ(corners.most_radius, 5);
  ASSERT_EQ(corners.sweeps.size(), 1u);
  EXPECT_EQ(corners.sweeps[0].part, (FlightPart{2, Manoeuvre::corner}));
  EXPECT_EQ(corners.sweeps[0].hull,
            (std::vector<Vec3>{{45, 0, 9}, {50, 0, 9}, {50, 5, 9}, {52, 0, 9}}));
}

TEST(CornersOf, BrakeFromTheLeastRadius) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 50, 9}};
  const std::vector<Turn> turns = {kRest, {Turn::pass, 5, 2}, kRest};
  EXPECT_EQ(corners_of(path, turns, kLegs, 7).sweeps[0].hull.back(), Vec3(55, 0, 9));
}

TEST(CornersOf, AreNotSweptWhereTheVehicleGoesToThePoint) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 50, 9}};
  const Corners corners = corners_of(path, std::vector<Turn>{kRest, pass(0), kRest}, kLegs, 7);
  EXPECT_EQ(corners.count, 1u);
  EXPECT_TRUE(corners.sweeps.empty());
}

TEST(CornersOf, HoldPointsThatMayBeReachedAtOnce) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 9, 9}, {0, 50, 9}, {0, 0, 9}};
  const std::vector<FlightPart> legs(5, {2, Manoeuvre::leg});
  const auto far =
      corners_of(path, std::vector<Turn>{kRest, pass(5), pass(3), kRest, kRest}, legs, 0);
  EXPECT_EQ(far.sweeps[0].hull.size(), 3u);
  const auto near =
      corners_of(path, std::vector<Turn>{kRest, pass(5), pass(4), kRest, kRest}, legs, 0);
  EXPECT_EQ(near.sweeps[0].hull.back(), path[3]);
  const auto on =
      corners_of(path, std::vector<Turn>{kRest, pass(5), pass(4), pass(10), kRest}, legs, 0);
  EXPECT_EQ(on.sweeps[0].hull.back(), Vec3(0, 40, 9)) << "and turns there";
}

}  // namespace
}  // namespace traj
