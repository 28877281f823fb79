#include "traj/together/spacing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/usage_error.h"

namespace traj {
namespace {

TEST(Spacing, IsTheSumOfTheRoomsRoundedUpWhereNoZoneIsSaid) {
  const auto zones = zones_between({}, {0.1, 1, 2}, {0.2, 3, 4});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_FALSE(zones[0].round);
  EXPECT_GE(zones[0].reach.x(), 0.1 + 0.2);
  EXPECT_EQ(zones[0].reach.y(), 4);
  EXPECT_EQ(zones[0].reach.z(), 6);
}

TEST(Spacing, HasTheDownwashBeside) {
  const auto zones = zones_between({cylinder(10, 2), cylinder(1, 8)}, {1, 1, 1}, {1, 1, 1});
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_EQ(zones[0].reach, Vec3(10, 10, 2));
  EXPECT_EQ(zones[1].reach, Vec3(1, 1, 8));
}

TEST(Spacing, ReachesCoverTheZonesTogether) {
  const Vec3 rooms[] = {{0.1, 0.7, 1e-3}, {0.3, 1e3, 0.2}};
  const Spacing all[] = {{}, {cylinder(0.3, 7), {}}, {{}, cylinder(0.5, 40)}};
  for (const Spacing& spacing : all) {
    const Vec3 sum = reach_of(spacing, rooms[0]) + reach_of(spacing, rooms[1]);
    for (const Zone& zone : zones_between(spacing, rooms[0], rooms[1])) {
      EXPECT_TRUE((sum.array() >= zone.reach.array()).all());
    }
  }
}

TEST(Spacing, IsRefusedWhereItIsNone) {
  EXPECT_FALSE(spacing_fault(cylinder(32, 7.62)));
  EXPECT_TRUE(spacing_fault(cylinder(0, 5)));
  EXPECT_TRUE(spacing_fault(cylinder(5, -1)));
  EXPECT_TRUE(spacing_fault(cylinder(std::nan(""), 5)));
  EXPECT_TRUE(spacing_fault({false, {1, 1, INFINITY}}));
}

TEST(Spacing, MeasuresInItsOwnNorm) {
  const Zone round = cylinder(5, 2);
  EXPECT_DOUBLE_EQ(share_of(round, {3, 4, 0}), 1);
  EXPECT_DOUBLE_EQ(share_of(round, {0, 0, -1}), 0.5);
  EXPECT_DOUBLE_EQ(depth_in(round, {0, 4, 1.5}), 0.5);
  EXPECT_LT(depth_in(round, {4, 4, 0}), 0);
  const Zone box{false, {5, 4, 2}};
  EXPECT_DOUBLE_EQ(share_of(box, {4, 4, 0}), 1);
  EXPECT_DOUBLE_EQ(depth_in(box, {4, 1, 0}), 1);
}

// Two vehicles that keep out of a zone which is smaller than they are may touch.
TEST(VehiclesInZone, RefusesAZoneThatIsSmallerThanTwoVehicles) {
  VehiclesInZone wide(cylinder(2, 1));
  wide.add("a", {1, 1, 0.5});
  EXPECT_NO_THROW(wide.add("b", {1, 1, 0.5}));
  EXPECT_THROW(wide.add("c", {1.5, 1, 0.25}), geom::UsageError);
  EXPECT_THROW(wide.add("d", {1, 1, 0.75}), geom::UsageError);
  VehiclesInZone one(cylinder(0.1, 0.1));
  EXPECT_NO_THROW(one.add("a", {1, 1, 1})) << "alone";
  EXPECT_NO_THROW(one.add("a", {1, 1, 1})) << "another way of it";
  EXPECT_THROW(one.add("b", {0.01, 0.01, 0.01}), geom::UsageError);
  VehiclesInZone sizes;
  sizes.add("a", {1, 1, 1});
  EXPECT_NO_THROW(sizes.add("b", {1, 1, 1}));
}

}  // namespace
}  // namespace traj
