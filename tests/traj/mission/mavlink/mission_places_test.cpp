#include "mission/mavlink/mission_places.h"

#include <gtest/gtest.h>

#include <memory>

#include "traj/mission/mavlink/mission_maker.h"

namespace traj {
namespace {

using testing::expect_near;
using testing::kArduPilot;
using testing::kHomeFrame;
using testing::kPx4;
using Maker = testing::MissionMaker;

TEST(MissionPlaces, TakesHeightsAboveFlatTerrain) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30});
  maker.mission().items.back().frame = kGlobalTerrain;
  EXPECT_EQ(
      maker.refusal(),
      "m: item 2: expected heights above sea level or home, found one above terrain: where "
      "the ground is flat, give its height; over other ground an autopilot follows terrain data of "
      "its own, which no file shows: give a height model of it (--ground-model)");
  EXPECT_NEAR(maker.fly({.ground = 3}).path.back().z(), 23, 1e-9);
  EXPECT_TRUE(maker.fly({.ground = 3}).counts_from_flat_ground);
}

// The sea level falls by 1 m to the east of home.
TEST(MissionPlaces, TakesTheSeaLevelAtEachPlace) {
  MissionFrame frame = kHomeFrame;
  frame.geoid_grid =
      std::make_shared<const geom::GeoidGrid>(geom::GeoidGrid{.south = 46,
                                                              .west = 7.998,
                                                              .north_step = 2,
                                                              .east_step = 0.002,
                                                              .columns = 3,
                                                              .rows = 2,
                                                              .heights = {3, 2, 1, 3, 2, 1},
                                                              .error = 0.25});
  Maker maker;
  maker.add(kWaypoint, {75.9, 0, 30});
  MissionItem& item = maker.mission().items.back();
  item.frame = kGlobal;
  item.altitude = 430;
  const FlownMavlink flown = maker.fly({}, frame);
  EXPECT_NEAR(flown.home->z(), 12, 1e-3) << "410 m over a sea that is 2 m above the ellipsoid";
  EXPECT_NEAR(flown.path.back().z(), 31.5, 2e-3) << "75.9 m are half a cell, but for 0.2 m";
  EXPECT_NEAR(flown.path_stray.z(), kMissionStray.z() + 0.25, 1e-12) << "the grid's error";
  EXPECT_TRUE(flown.counts_from_sea);
  EXPECT_NEAR(maker.fly({.home = 10}, frame).path_stray.z(), kMissionStray.z() + 0.25, 1e-12);
  Maker relative;
  relative.add(kWaypoint, {75.9, 0, 30});
  EXPECT_EQ(relative.fly({.home = 10}, frame).path_stray.z(), kMissionStray.z())
      << "no height of it counts from the sea";
}

TEST(MissionPlaces, SaysTheHomeThatItAssumed) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30});
  expect_near(*maker.fly().home, {0, 0, 10});
  expect_near(*maker.fly({.home = 12}).home, {0, 0, 12});
  maker.mission().home.reset();
  expect_near(*maker.fly({.home = 12}).home, {0, 0, 12});
}

// Its home is 410 m above the sea, and that says nothing of the map's z.
TEST(MissionPlaces, CountsFromTheGroundThatIsGivenWhereTheMapsHeightIsNotKnown) {
  const MissionFrame unknown{{47, 8, 0}, 0, false};
  Maker maker;
  maker.add(kWaypoint, {100, 0, 30}, {2, 0, 0, 0});
  EXPECT_EQ(maker.refusal({}, unknown),
            "m: item 1: heights count from home, which the file gives above the sea, and the map "
            "does not say how high its z = 0 is: give the map's z of the ground there (--ground)");
  const FlownMavlink flown = maker.fly({.home = 3}, unknown);
  EXPECT_EQ(flown.ends.takeoff_from, 3);
  EXPECT_NEAR(flown.path.back().z(), 23, 1e-9);
}

TEST(MissionPlaces, RefusesHeightsAboveTheSeaWhereTheMapsHeightIsNotKnown) {
  const MissionFrame unknown{{47, 8, 0}, 0, false};
  for (const int frame : {kGlobal, kGlobalInt}) {
    Maker maker;
    maker.add(kWaypoint, {100, 0, 30});
    maker.mission().items.back().frame = frame;
    EXPECT_EQ(maker.refusal({.home = 3}, unknown),
              "m: item 2: expected heights above home, found one above the sea, and the map does "
              "not say how high its z = 0 is: give --origin latitude,longitude,height");
  }
}

// Else the way up from the ground would be left out.
TEST(MissionPlaces, RefusesATakeOffFromAGroundThatNobodyGave) {
  Maker maker;
  maker.add(kWaypoint, {100, 0, 430}, {2, 0, 0, 0});
  maker.mission().items[0].altitude = 430;
  for (MissionItem& item : maker.mission().items) item.frame = kGlobal;
  EXPECT_EQ(maker.fly().ends.takeoff_from, 10);
  maker.mission().home.reset();
  EXPECT_EQ(maker.refusal(),
            "m: item 1: heights count from home, and the file has no home: give the height of the "
            "ground there (--ground)");
  EXPECT_EQ(maker.fly({.home = 12}).ends.takeoff_from, 12);
}

TEST(MissionPlaces, TakesZerosAsTheAutopilotDoes) {
  Maker height;
  height.add(kWaypoint, {100, 0, 40}).add(kWaypoint, {100, 80, 10});
  expect_near(height.fly(kArduPilot).path.back(), {100, 80, 40});
  expect_near(height.fly(kPx4).path.back(), {100, 80, 10});
  EXPECT_EQ(height.refusal(),
            "m: item 3: expected an altitude, found 0: ArduPilot then keeps its height, and PX4 "
            "flies at that of home: say which of them flies it (--autopilot)");
  height.mission().items.back().altitude = 0.0099;
  expect_near(height.fly(kArduPilot).path.back(), {100, 80, 40});
  Maker place;
  place.add(kWaypoint, {100, 0, 40}).add(kLoiterTime, {0, 0, 50}, {5, 0, 0, 0});
  place.mission().items.back().latitude = place.mission().items.back().longitude = 0;
  expect_near(place.fly(kArduPilot).path.back(), {100, 0, 50});
  EXPECT_EQ(place.refusal(),
            "m: item 3: expected a place, found latitude 0, longitude 0: ArduPilot then stays "
            "where it is, and PX4 flies there: say which of them flies it (--autopilot)");
  EXPECT_EQ(place.refusal(kPx4), "m: item 3: expected a place near the origin 47 8, found 0 0");
}

}  // namespace
}  // namespace traj
