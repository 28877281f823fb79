#include "traj/mission/formats/wpl.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/reading.h"
#include "traj/mission/mavlink/examples.h"
#include "traj/mission/mavlink/mission.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj {
namespace {

using testing::every_item;
using testing::expect_same;

FlownMavlink fly(const std::string& items) {
  return flown_mission(read_wpl(support::Text("QGC WPL 110\n" + items), "m.wpl"), {{47, 8, 400}, 0},
                       {}, "m.wpl");
}

std::string refusal(const std::string& items) {
  return support::refusal_of([&] { fly(items); });
}

constexpr const char* kHome = "0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n";

TEST(Wpl, ReadsTakeOffsWithoutPlaceLoiteringDelaysAndReturns) {
  const FlownMavlink flown = fly(std::string(kHome) +
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
  EXPECT_EQ(refusal(home + "0\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: index must be a whole number from 1 on, found 0");
  EXPECT_EQ(
      refusal(home + "1\t0\t3\t84\t0\t0\t0\t0\t47\t8\t15\t1\n"),
      "m.wpl:3: expected waypoints (16, 82), take-offs (22), landings (21), loitering (17, 18, 19, "
      "31), a return (20), delays (93), payload places (94), jumps (177), speeds (178) or what is "
      "known to move nothing, found command 84");
  EXPECT_EQ(
      refusal(home + "1\t0\t10\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
      "m.wpl:3: expected heights above sea level or home, found one above terrain: where the "
      "ground is flat, give its height; over other ground an autopilot follows terrain data of "
      "its own, which no file shows: give a height model of it (--ground-model)");
  EXPECT_EQ(refusal(home + "1\t0\t8\t16\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: frame must be 0, 3, 5, 6, 10 or 11 (above sea level, home or terrain), found "
            "8");
  EXPECT_EQ(
      refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t47\t8\t0\t1\n"),
      "m.wpl:3: expected an altitude, found 0: ArduPilot then keeps its height, and PX4 flies at "
      "that of home: say which of them flies it (--autopilot)");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t97\t8\t15\t1\n"),
            "m.wpl:3: latitude and longitude must be within 90 and 180 degrees, found 97 8");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t0\t0\t0\t0\t-33\t151\t15\t1\n"),
            "m.wpl:3: expected a place near the origin 47 8, found -33 151");
  EXPECT_EQ(refusal("0\t1\t3\t22\t0\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:2: heights count from home, and the file has no home: give the height of the "
            "ground there (--ground)");
  EXPECT_EQ(refusal(home + "1\t0\t3\t16\t-1\t0\t0\t0\t47\t8\t15\t1\n"),
            "m.wpl:3: a hold must be >= 0 s, found -1");
  EXPECT_EQ(refusal(home + "1\t0\t2\t20\t0\t0\t0\t0\t0\t0\t0\t1\n"),
            "m.wpl: expected at least one waypoint, found none");
  EXPECT_EQ(support::refusal_of([&] { read_wpl(support::Text("QGC WPL 100\n"), "m.wpl"); }),
            "m.wpl:1: expected \"QGC WPL 110\", found \"QGC WPL 100\"");
}

Mission read(const std::string& text) { return read_wpl(support::Text(text), "m.wpl"); }

const std::string kItem = "\t0\t3\t16\t0\t0\t0\t0\t47\t8\t15\t1";

TEST(Wpl, ReadsWhetherAnItemGoesOn) {
  const Mission mission = read(
      "QGC WPL "
      "110\n0\t1\t3\t16\t0\t2\t0\t0\t47\t8\t30\t1\n1\t0\t3\t16\t0\t2\t0\t0\t47\t8\t30\t0\n");
  EXPECT_TRUE(mission.items[0].goes_on);
  EXPECT_FALSE(mission.items[1].goes_on);
}

TEST(Wpl, RefusesARallyPointWhoseHeightDoesNotCountFromHome) {
  const std::string home = kHome;
  EXPECT_EQ(refusal(home + "1\t0\t0\t5100\t0\t0\t0\t0\t47\t8\t400\t1\n"),
            "m.wpl:3: frame must be 3 or 6 for a rally point, whose height counts from home, found "
            "0");
}

TEST(Wpl, TakesWhatGroundStationsWrite) {
  const Mission windows = read(
      "\xef\xbb\xbfQGC WPL 110\r\n# made by hand\r\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410"
      "\t1\r\n1" +
      kItem + "\r\n");
  EXPECT_TRUE(windows.home);
  EXPECT_EQ(windows.items.size(), 1u);
  EXPECT_TRUE(windows.notes.empty());
  const Mission old = read("QGC WPL 120\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t410\t1\n1" + kItem + "\n");
  EXPECT_FALSE(old.home) << "version 120 has no home";
  EXPECT_EQ(old.items.size(), 2u);
}

// ArduPilot and QGroundControl have home in the place of the first item, whatever it is.
TEST(Wpl, ArdupilotDoesNotFlyTheFirstItem) {
  const std::string items =
      "0\t1\t3\t22\t0\t0\t0\t0\t47\t8\t15\t1\n1\t0\t3\t16\t0\t2\t0\t0\t47\t8.001\t15\t1\n";
  const auto flown = [&](const char* version, const char* pilot) {
    const Mission mission = read_wpl(support::Text(version + items), "m.wpl");
    const MissionRules rules{.home = 10, .autopilots = *autopilots_of(pilot)};
    return flown_mission(mission, {{47, 8, 400}, 0}, rules, "m.wpl");
  };
  const FlownMavlink any = flown("QGC WPL 110\n", "any");
  ASSERT_EQ(any.drift.size(), 1u);
  EXPECT_TRUE(any.drift[0].autopilot.starts_with("px4")) << any.drift[0].autopilot;
  EXPECT_EQ(flown("QGC WPL 120\n", "any").drift.size(), 2u) << "home is in no item";
  EXPECT_EQ(
      support::refusal_of([&] { flown("QGC WPL 110\n", "ardupilot"); }),
      "m.wpl:2: expected home as the first item (frame 0, command 16), found frame 3, command "
      "22: ArduPilot takes the first item for home and does not fly it: put home before it, or "
      "say that PX4 flies it (--autopilot px4)");
  EXPECT_FALSE(read(std::string("QGC WPL 110\n") + kHome + "1" + kItem + "\n").first_for_home);
}

TEST(Wpl, CountsAnewWhatSkipsNumbers) {
  const Mission mission = read("QGC WPL 110\n1" + kItem + "\n5" + kItem + "\n");
  ASSERT_EQ(mission.items.size(), 2u);
  EXPECT_EQ(mission.items[1].number, 5u);
  EXPECT_EQ(mission.notes.size(), 1u);
  EXPECT_EQ(
      support::refusal_of(
          [&] { read("QGC WPL 110\n1" + kItem + "\n5\t0\t3\t177\t1\t2\t0\t0\t0\t0\t0\t1\n"); }),
      "m.wpl:3: expected numbers that begin at 0 and leave none out, as a jump counts on them, "
      "found others");
}

std::string fence(int number, int command, double value, const char* place) {
  return std::to_string(number) + "\t0\t3\t" + std::to_string(command) + "\t" +
         std::to_string(value) + "\t0\t0\t0\t" + place + "\t0\t1\n";
}

TEST(Wpl, ReadsFencesAndRallyPointsOfTheSameFile) {
  const std::string items = "QGC WPL 110\n0" + kItem + "\n";
  const std::string corners =
      fence(1, 5002, 3, "47\t8") + fence(2, 5002, 3, "47\t8.1") + fence(3, 5002, 3, "47.1\t8");
  const Mission mission = read(items + corners + fence(4, 5003, 250, "47\t8") +
                               fence(5, 5000, 0, "47\t8") + fence(6, 5100, 0, "47.2\t8"));
  ASSERT_EQ(mission.fences.size(), 2u);
  EXPECT_FALSE(mission.fences[0].inclusion);
  EXPECT_EQ(mission.fences[0].ring.size(), 3u);
  EXPECT_TRUE(mission.fences[1].inclusion);
  EXPECT_EQ(mission.fences[1].radius, 250);
  EXPECT_EQ(mission.rally.size(), 1u);
  const auto bad = [&](const std::string& text) {
    return support::refusal_of([&] { read(text); });
  };
  EXPECT_EQ(bad(items + fence(1, 5002, 3, "47\t8") + fence(2, 5001, 3, "47\t8.1")),
            "m.wpl:4: expected 2 more corners of the fence before, found another");
  EXPECT_EQ(bad(items + fence(1, 5002, 3, "47\t8") + fence(2, 5002, 3, "47\t8.1")),
            "m.wpl: expected 1 more corners of a fence, found the end of the file");
  EXPECT_EQ(bad(items + fence(1, 5002, 2, "47\t8")),
            "m.wpl:3: a fence must have 3 corners or more, found 2");
  EXPECT_EQ(
      bad("QGC WPL 110\n" + fence(0, 5004, 9, "47\t8") + "1" + kItem +
          "\n2\t0\t3\t177\t1\t2\t0\t0\t0\t0\t0\t1\n"),
      "m.wpl:4: expected numbers that begin at 0 and leave none out, as a jump counts on them, "
      "found others");
  EXPECT_EQ(bad("QGC WPL 110\n" + fence(0, 5004, 9, "47\t8")),
            "m.wpl: expected a mission, found only a fence or rally points");
}

TEST(Wpl, KnowsWhatEndsWhatCutsCornersAndWhatSpeedIsSaid) {
  const std::string takeoff = std::string(kHome) + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n";
  const std::string corner = takeoff + "2\t0\t3\t16\t0\t2\t0\t0\t47.001\t8\t15\t1\n" +
                             "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8.001\t15\t1\n";
  EXPECT_EQ(fly(corner).corners, 1u);
  EXPECT_EQ(fly(corner).acceptance, 2);
  EXPECT_FALSE(fly(corner).ended);
  EXPECT_FALSE(fly(corner).speed);
  const std::string speed = takeoff + "2\t0\t2\t178\t1\t5\t-1\t0\t0\t0\t0\t1\n";
  const std::string rest = speed + "3\t0\t3\t16\t1\t2\t0\t0\t47.001\t8\t15\t1\n" +
                           "4\t0\t3\t21\t0\t0\t0\t0\t47.001\t8\t0\t1\n";
  EXPECT_EQ(fly(rest).corners, 0u);
  EXPECT_TRUE(fly(rest).ended);
  EXPECT_EQ(fly(rest).speed, 5);
  EXPECT_EQ(fly(rest).takeoff_from_home, 0);
  const FlownMavlink away =
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
  EXPECT_EQ(passed, 32u + 11u + 4u) << "what is listed, and 16, 17, 19, 20, 21, 31, 82, 93, 94, "
                                       "177, 178, and of fences and rally "
                                       "points";
}

TEST(Wpl, ComesBackItemByItem) {
  const Mission mission = every_item();
  std::stringstream file;
  write_wpl(file, mission);
  const Mission back = read_wpl(file, "m.wpl");
  expect_same(back, mission);
}

TEST(Wpl, TakesZerosForNoHome) {
  const Mission mission = read(
      "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1\n"
      "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t15\t1\n");
  EXPECT_FALSE(mission.home);
  ASSERT_EQ(mission.notes.size(), 1u);
  EXPECT_EQ(mission.notes[0],
            "its home is latitude 0, longitude 0, which is taken for none: home is below the first "
            "point");
}

TEST(Wpl, FencesAndRallyPointsComeBackFromFilesOfTheirOwn) {
  Mission mission = every_item();
  mission.fences.push_back({true, {{47, 8, 0}, {47.001, 8, 0}, {47.001, 8.0000001, 0}}, {}, 0});
  mission.fences.push_back({false, {}, {47.0005, 8.0001, 0}, 12.5});
  mission.rally.push_back({47.0002, 8.0003, 30.125});
  std::stringstream of_fences;
  write_wpl_fences(of_fences, mission);
  const auto back = read_wpl_fences(of_fences, "fence.waypoints");
  ASSERT_EQ(back.size(), 2u);
  EXPECT_TRUE(back[0].inclusion);
  EXPECT_EQ(back[0].ring, mission.fences[0].ring);
  EXPECT_FALSE(back[1].inclusion);
  EXPECT_TRUE(back[1].ring.empty());
  EXPECT_EQ(back[1].centre, mission.fences[1].centre);
  EXPECT_EQ(back[1].radius, 12.5);
  std::stringstream of_rally;
  write_wpl_rally(of_rally, mission);
  EXPECT_EQ(read_wpl_rally(of_rally, "rally.waypoints"), mission.rally);
}

}  // namespace
}  // namespace traj
