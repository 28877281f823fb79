#include "traj/drone_file/wpl.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/refusal.h"
#include "traj/drone_file/examples.h"
#include "traj/drone_file/mission.h"

namespace traj {
namespace {

using testing::every_item;
using testing::expect_same;

FlownMission fly(const std::string& items) {
  std::istringstream in("QGC WPL 110\n" + items);
  return flown_mission(read_wpl(in, "m.wpl"), {{47, 8, 400}, 0}, {}, "m.wpl");
}

std::string refusal(const std::string& items) {
  return support::refusal_of([&] { fly(items); });
}

constexpr const char* kHome = "0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n";

TEST(Wpl, ReadsTakeOffsWithoutPlaceLoiteringDelaysAndReturns) {
  const FlownMission flown = fly(std::string(kHome) +
                                 "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n"
                                 "2\t0\t3\t19\t7\t0\t0\t0\t47.001\t8\t20\t1\n"
                                 "3\t0\t2\t93\t2\t0\t0\t0\t0\t0\t0\t1\n"
                                 "4\t0\t0\t16\t0\t0\t0\t0\t47.001\t8.001\t440\t1\n"
                                 "5\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n");
  ASSERT_EQ(flown.path.size(), 3u);
  EXPECT_LT((flown.path[0] - Vec3(0, 0, 25)).norm(), 1e-6);
  EXPECT_NEAR(flown.path[1].y(), 111.17, 0.05);
  EXPECT_EQ(flown.path[1].z(), 30);
  EXPECT_EQ(flown.path[2].z(), 40) << "above the sea";
  EXPECT_EQ(flown.hold, (std::vector<double>{0, 9, 0}));
  EXPECT_TRUE(flown.returns);
  EXPECT_TRUE(flown.ended);
}

TEST(Wpl, BadFilesAreRefused) {
  const std::string home = kHome;
  EXPECT_EQ(refusal(home), "m.wpl: expected \"QGC WPL 110\" and at least one item, found none");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\n"),
            "m.wpl:3: expected 12 fields separated by tabs, found 11");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t47,5\t8\t15\t1\n"),
            "m.wpl:3: latitude must be a number with a decimal point, found \"47,5\"");
  EXPECT_EQ(refusal(home + "2\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: index must be 1, the next, found 2");
  EXPECT_EQ(
      refusal(home + "1\t0\t3\t82\t0\t0\t0\t0\t47\t8\t15\t1\n"),
      "m.wpl:3: expected waypoints (16), take-offs (22), landings (21), loitering (17, 19), a "
      "return (20), delays (93), speeds (178) or what is known to move nothing, found command 82");
  EXPECT_EQ(refusal(home + "1\t0\t10\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: frame must be 0, 3, 5 or 6 (above sea level or home), found 10");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t97\t8\t15\t1\n"),
            "m.wpl:3: latitude and longitude must be within 90 and 180 degrees, found 97 8");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t-33\t151\t15\t1\n"),
            "m.wpl:3: expected a place near the origin 47 8, found -33 151");
  EXPECT_EQ(refusal("0\t1\t3\t22\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:2: heights count from home, and the file has no home: give the height of the "
            "ground there");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t-1\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: a hold must be >= 0 s, found -1");
  EXPECT_EQ(refusal(home + "1\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n"),
            "m.wpl: expected at least one waypoint, found none");
  std::istringstream other("QGC WPL 120\n");
  EXPECT_THROW(read_wpl(other, "m.wpl"), geom::InputError);
  std::istringstream crlf("QGC WPL 110\r\n");
  try {
    read_wpl(crlf, "m.wpl");
    FAIL();
  } catch (const geom::InputError& error) {
    EXPECT_STREQ(error.what(), "m.wpl:1: expected a line that ends with LF, found CRLF");
  }
}

TEST(Wpl, KnowsWhatEndsWhatCutsCornersAndWhatSpeedIsSaid) {
  const std::string takeoff = std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n";
  const std::string corner = takeoff + "2\t0\t3\t16\t0\t2\t0\t0\t47.001\t8\t15\t1\n" +
                             "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8.001\t15\t1\n";
  EXPECT_TRUE(fly(corner).cuts_corners);
  EXPECT_FALSE(fly(corner).ended);
  EXPECT_FALSE(fly(corner).speed);
  const std::string speed = takeoff + "2\t0\t2\t178\t1\t5\t-1\t0\t0\t0\t0\t1\n";
  const std::string rest = speed + "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8\t15\t1\n" +
                           "4\t0\t3\t21\t0\t0\t0\t0\t47.001\t8\t0\t1\n";
  EXPECT_FALSE(fly(rest).cuts_corners);
  EXPECT_TRUE(fly(rest).ended);
  EXPECT_EQ(fly(rest).speed, 5);
  EXPECT_EQ(fly(rest).takeoff_from_home, 0);
  const FlownMission away =
      fly(std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t47.0001\t8\t15\t1\n");
  ASSERT_EQ(away.path.size(), 2u) << "up at home, then there";
  EXPECT_LT((away.path[0] - Vec3(0, 0, 25)).norm(), 1e-6);
  EXPECT_NEAR(away.takeoff_from_home, 11.1, 0.1);
}

TEST(Wpl, WhatIsNotKnownToMoveNothingIsRefused) {
  const std::string takeoff = std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n";
  std::size_t passed = 0;
  for (int command = 0; command < 40000; ++command) {
    const std::string items =
        takeoff + "2\t0\t3\t" + std::to_string(command) + "\t1\t0\t0\t0\t47.001\t8\t15\t1\n";
    if (refusal(items).empty()) ++passed;
  }
  EXPECT_EQ(passed, 31u + 7u) << "what is listed, and 16, 17, 19, 20, 21, 93, 178";
}

TEST(Wpl, ComesBackItemByItem) {
  const Mission mission = every_item();
  std::stringstream file;
  write_wpl(file, mission);
  const Mission back = read_wpl(file, "m.wpl");
  expect_same(back, mission);
}

}  // namespace
}  // namespace traj
