#include "mission/mavlink/mission_circle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "traj/mission/mavlink/mission_maker.h"

namespace traj {
namespace {

using testing::expect_near;
using testing::swept;
using Maker = testing::MissionMaker;

TEST(MissionCircle, IsFlownFromItsNearestPoint) {
  Maker maker;
  maker.add(kWaypoint, {0, 20, 30}, {1, 0.2, 0, 0}).add(kLoiterTurns, {0, 100, 40}, {2, 0, 25, 0});
  maker.add(kWaypoint, {80, 75, 40});
  const FlownMavlink flown = maker.fly();
  expect_near(flown.path[2], {0, 75, 40});
  EXPECT_EQ(flown.path.size(), 2u + 33u + 1u);
  for (double angle = 0; angle < 6.3; angle += 0.01) {
    const Vec3 p(25 * std::cos(angle), 100 + 25 * std::sin(angle), 40);
    EXPECT_TRUE(swept(flown, Manoeuvre::circle, p)) << angle;
  }
  EXPECT_FALSE(swept(flown, Manoeuvre::circle, {0, 100, 40})) << "a tower may stand in it";
  expect_near(flown.path[flown.path.size() - 2], {0, 75, 40});
  EXPECT_TRUE(swept(flown, Manoeuvre::leg, {40, 75, 40}));
}

TEST(MissionCircle, IsRefusedWhereItsPlaceIsNotKnown) {
  const Vec3 centre(0, 100, 40);
  EXPECT_EQ(Maker().add(kLoiterTurns, centre, {1.5, 0, 25, 0}).refusal(),
            "m: item 2: expected whole turns on a circle, at least one, found 1.5");
  EXPECT_EQ(Maker().add(kLoiterTurns, centre, {1, 0, 0, 0}).refusal(),
            "m: item 2: expected the radius of the circle, found 0: it would be the vehicle's own");
  EXPECT_EQ(
      Maker().add(kLoiterTurns, centre, {1, 0, 10.9, 0}).refusal(),
      "m: item 2: expected a radius of whole metres, or of tens above 255, as ArduPilot keeps "
      "it, found 10.9");
  EXPECT_EQ(Maker().add(kLoiterTurns, centre, {1, 0, 2e4, 0}).refusal(),
            "m: item 2: a radius must be within 1e4 m, found 20000");
  EXPECT_EQ(Maker()
                .add(kWaypoint, {0, 95, 40}, {1, 0.2, 0, 0})
                .add(kLoiterTurns, centre, {1, 0, 25, 0})
                .refusal(),
            "m: item 3: expected to come to the circle from outside of half its radius, found a "
            "point nearer to its centre: where the circle begins is uncertain");
  EXPECT_EQ(
      Maker()
          .add(kLoiterTime, {0, 50, 30}, {9, 0, 5, 0})
          .add(kLoiterTurns, centre, {1, 0, 25, 0})
          .refusal(),
      "m: item 3: expected a waypoint before a circle, so that it is known where that begins, "
      "found loitering, a delay, a short hold or a take-off away from home");
}

}  // namespace
}  // namespace traj
