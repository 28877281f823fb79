#include "drone_file/mission_corners.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

constexpr Turn kRest{Turn::rest, 0};

Turn pass(double radius) { return {Turn::pass, radius}; }

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

TEST(CornersOf, AreNotSweptWhereTheVehicleGoesToThePoint) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 50, 9}};
  const Corners corners = corners_of(path, std::vector<Turn>{kRest, pass(0), kRest}, kLegs, 7);
  EXPECT_EQ(corners.count, 1u);
  EXPECT_TRUE(corners.sweeps.empty());
}

TEST(CornersOf, HoldPointsThatAreReachedAtOnce) {
  const std::vector<Vec3> path = {{0, 0, 9}, {50, 0, 9}, {50, 4, 9}, {0, 50, 9}};
  const auto far = corners_of(path, std::vector<Turn>{kRest, pass(5), pass(3), kRest}, kLegs, 0);
  EXPECT_EQ(far.sweeps[0].hull.size(), 3u);
  const auto near = corners_of(path, std::vector<Turn>{kRest, pass(5), pass(4), kRest}, kLegs, 0);
  EXPECT_EQ(near.sweeps[0].hull.back(), path[3]);
}

}  // namespace
}  // namespace traj
