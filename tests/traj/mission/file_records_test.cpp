#include "traj/mission/file_records.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

const geom::Provenance kMadeFor{.margin = 0.5};

FileFlight file_of(Flown flown) {
  return {"f1", mission_format_named("tello"), std::move(flown), {}};
}

TEST(FileRecords, HaveTheLegsOfAFlightAndTheirHolds) {
  FlownLegs legs;
  legs.path = {{0, 0, 5}, {9, 0, 5}};
  legs.hold = {0, 2};
  legs.ends.takeoff_from = 0;
  legs.ends.landing_on = 1;
  const auto record = path_record(file_of({legs}), kMadeFor);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->id, "f1");
  EXPECT_EQ(record->points, legs.path);
  EXPECT_EQ(record->hold, legs.hold);
  EXPECT_EQ(record->provenance.margin, 0.5);
  EXPECT_FALSE(regions_record(file_of({legs}), kMadeFor));
}

TEST(FileRecords, HaveTheAscentAndTheDescentIfAsked) {
  FlownLegs legs;
  legs.path = {{0, 0, 5}, {9, 0, 5}};
  legs.ends.takeoff_from = 0;
  legs.ends.landing_on = 1;
  const geom::Polyline whole = {{0, 0, 0}, {0, 0, 5}, {9, 0, 5}, {9, 0, 1}};
  EXPECT_EQ(path_record(file_of({legs}), kMadeFor, true)->points, whole);
  legs.ends.landing_on = 7;  // above its last point
  EXPECT_EQ(path_record(file_of({legs}), kMadeFor, true)->points.size(), 3u);
}

TEST(FileRecords, HaveTheCurveOfAFlight) {
  FlownCurve curve;
  curve.trajectory.segments = {hermite({Vec3(0, 0, 5)}, {Vec3(9, 0, 5)}, 10)};
  EXPECT_FALSE(path_record(file_of({curve}), kMadeFor));
  const TrajectoryRecord record = trajectory_record(file_of({curve}), kMadeFor);
  EXPECT_EQ(record.status, TrajectoryStatus::solved);
  EXPECT_EQ(duration(record.trajectory), 10);
}

TEST(FileRecords, HaveTheRegionsOfAMissionThatAreMoreThanALine) {
  FlownMission mission;
  mission.path = {{0, 0, 5}, {9, 0, 5}};
  mission.sweeps.resize(2);
  mission.sweeps[0].hull = {{0, 0, 5}, {1, 0, 5}};
  EXPECT_FALSE(regions_record(file_of({mission}), kMadeFor));
  mission.sweeps[1].hull = {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
  const auto shape = regions_record(file_of({mission}), kMadeFor);
  ASSERT_TRUE(shape);
  ASSERT_EQ(shape->pieces.size(), 1u);
  EXPECT_EQ(shape->pieces[0].faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
}

TEST(FileRecords, HaveTheBandsOfAMissionAboveTerrain) {
  FlownMission mission;
  mission.path = {{0, 0, 5}, {9, 0, 7}, {9, 0, 9}};
  mission.leg_band = {2, 1};
  mission.terrain = TerrainClaim{};
  const auto shape = regions_record(file_of({mission}), kMadeFor);
  ASSERT_TRUE(shape);
  ASSERT_EQ(shape->pieces.size(), 1u) << "an upright leg has no face";
  EXPECT_EQ(shape->pieces[0].vertices,
            (std::vector<Vec3>{{0, 0, 3}, {9, 0, 5}, {9, 0, 9}, {0, 0, 7}}));
}

}  // namespace
}  // namespace traj
