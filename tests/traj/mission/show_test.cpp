#include "traj/mission/show.h"

#include <gtest/gtest.h>

#include "traj/scenes.h"

namespace traj {
namespace {

// Along y = `y`, within 10 s.
ShowFlight flight(std::string id, double y, double start) {
  ShowFlight out{.id = id, .file = id + ".csv"};
  out.time.start = start;
  out.planned.segments = {hermite({Vec3(0, y, 5)}, {Vec3(9, y, 5)}, 10)};
  out.flown = out.planned;
  out.room = Vec3::Constant(0.5);
  return out;
}

TEST(CheckShow, AcceptsFlightsThatKeepApart) {
  const ShowFlight show[] = {flight("a", 0, 0), flight("b", 4, 0)};
  const ShowCheck check = check_show(show, {}, Parked::pad);
  EXPECT_TRUE(check.result.ok());
  EXPECT_EQ(check.result.pairs, 1u);
  EXPECT_EQ(check.task.ids, (std::vector<std::string>{"a", "b"}));
}

TEST(CheckShow, StartsFlightsAtTheirTimes) {
  const ShowFlight together[] = {flight("a", 0, 0), flight("b", 0, 0)};
  EXPECT_FALSE(check_show(together, {}, Parked::gone).result.ok());
  const ShowFlight apart[] = {flight("a", 0, 0), flight("b", 0, 20)};
  EXPECT_TRUE(check_show(apart, {}, Parked::gone).result.ok());
  EXPECT_FALSE(check_show(apart, {}, Parked::pad).result.ok());
}

TEST(CheckShow, GrowsZonesByTheRoundingOfTwoFiles) {
  ShowFlight show[] = {flight("a", 0, 0), flight("b", 4, 0)};
  const Spacing spacing{cylinder(3.9, 3), {}};
  EXPECT_TRUE(check_show(show, spacing, Parked::pad).result.ok());
  show[1].stray = Vec3(0, 0.1, 0);
  EXPECT_FALSE(check_show(show, spacing, Parked::pad).result.ok());
}

TEST(ReadBack, IsWhatTheFileSays) {
  const auto scene = testing::scene_of({}, {Vec3(-100, -100, 0), Vec3(100, 100, 50)});
  ShowFlight one = flight("a", 0, 0);
  ExportFlight way{"a", one.planned};
  const MissionFormat& format = *mission_format_named("crazyflie");
  const MissionExport made = export_mission(scene, way, format);
  ASSERT_TRUE(made.written) << made.refusal;
  const ShowFlight back = read_back({.id = "a", .file = "a.csv"}, scene, format, *made.written);
  EXPECT_LT((evaluate(back.flown, 5).position - evaluate(one.planned, 5).position).norm(), 1e-3);
  EXPECT_GT(back.stray.minCoeff(), 0);
  EXPECT_TRUE(((back.room - scene.half()).array() >= back.stray.array()).all());
}

TEST(ShowYaml, ListsFlightsInTheOrderOfTheirStarts) {
  const ShowFlight show[] = {flight("late", 0, 2.5), flight("first", 4, 0)};
  EXPECT_EQ(show_yaml(show, {}),
            R"(# When each file of this folder begins, in seconds after one instant.
# UNCHECKED: not compared with any map, nor with one another.
checked: false
flights:
  - id: "first"
    file: "first.csv"
    start: 0
    duration: 10
    initial_position: [0, 4, 5]
    final_position: [9, 4, 5]
  - id: "late"
    file: "late.csv"
    start: 2.5
    duration: 10
    initial_position: [0, 0, 5]
    final_position: [9, 0, 5]
)");
}

TEST(ShowYaml, SaysWhatWasProved) {
  ShowFlight one = flight("a", 0, 1e-7);
  one.time.epoch = "2026-05-04T06:30:00Z";
  const ShowFlight show[] = {one};
  const std::string text =
      show_yaml(show, {.checked = true, .spacing = {cylinder(5, 3), {}}, .parked = Parked::gone});
  EXPECT_NE(text.find("apart by 5 m across or 3 m in height, while"), std::string::npos) << text;
  EXPECT_NE(text.find("# Only in flight"), std::string::npos);
  EXPECT_NE(text.find("checked: true\nepoch: \"2026-05-04T06:30:00Z\"\n"), std::string::npos);
  EXPECT_NE(text.find("start: 1.0e-07\n"), std::string::npos) << text;
  EXPECT_NE(show_yaml(show, {.checked = true, .spare = 0.5}).find("margins less 0.5 m"),
            std::string::npos);
}

}  // namespace
}  // namespace traj
