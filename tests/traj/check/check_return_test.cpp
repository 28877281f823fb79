#include "traj/check/check_return.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/usage_error.h"
#include "support/reading.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/mavlink/mission_flight.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

Flier px4_flier() {
  Flier flier;
  flier.autopilots = {px4("1.17")};
  return flier;
}

TrajectoryRecord flight(const Vec3& from, const Vec3& to) {
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({from}, {to}, 10)};
  return record;
}

geom::PathRecord way(geom::Polyline points) {
  geom::PathRecord record{.id = "p1", .status = geom::PathStatus::found};
  record.points = std::move(points);
  return record;
}

FileFlight file_of(const char* format, Flown flown) {
  return {"f1", mission_format_named(format), std::move(flown), {}};
}

// Up from home, 60 m east, and back by a return.
FileFlight mission() {
  std::istringstream in(
      "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n"
      "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t30\t1\n"
      "2\t0\t3\t16\t2\t0\t0\t0\t47\t8.0008\t30\t1\n"
      "3\t0\t3\t20\t0\t0\t0\t0\t0\t0\t0\t1\n");
  MissionRules rules;
  rules.autopilots = {px4("1.17")};
  rules.return_height = 60;
  return file_of("wpl", {static_cast<const FlownMission&>(
                            flown_mission(read_wpl(in, "m"), {{47, 8, 400}, 0}, rules, "m"))});
}

FileFlight dji(std::optional<double> speed, std::optional<double> return_height) {
  FlownMission made;
  made.path = {{20, 0, 40}, {60, 0, 40}};
  made.hold = {0, 0};
  made.legs = {{0, Manoeuvre::leg}, {1, Manoeuvre::leg}};
  made.home = Vec3(0, 0, 0);
  made.speed = speed;
  made.return_height = return_height;
  return file_of("dji-wpml", {made});
}

template <class F>
std::string refusal_of(const F& f) {
  try {
    f();
  } catch (const geom::UsageError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const FileFlight& file, const ReturnRules& rules) {
  return refusal_of([&] { check_return(scene_of({}), file, px4_flier(), rules); });
}

TEST(CheckReturn, OfATrajectoryLandsBelowItsBeginning) {
  const geom::Aabb roof{{-9, -9, 0}, {9, 9, 12}};
  const ReturnReport report =
      check_return(scene_of({roof}), flight({0, 0, 30}, {60, 0, 30}), px4_flier(), {});
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.home, Vec3(0, 0, 12));
  EXPECT_EQ(report.height, return_model(px4("1.17")).height);
  EXPECT_EQ(report.duration, 10);
  ASSERT_TRUE(report.least_height);
  EXPECT_LE(*report.least_height, report.height);
}

TEST(CheckReturn, TakesHomeAndHeightFromTheRules) {
  const geom::Aabb wall{{-30, -90, 0}, {-25, 90, 70}};
  ReturnRules rules{.home = Vec3(-60, 0, 0)};
  const auto scene = scene_of({wall});
  Flier flier = px4_flier();
  flier.autopilots.front().return_slope = 0;  // else it may stay low near home
  const ReturnReport low = check_return(scene, flight({0, 0, 30}, {60, 0, 30}), flier, rules);
  ASSERT_FALSE(low.ok());
  EXPECT_EQ(low.gaps.front().phase, "way");
  EXPECT_EQ(low.gaps.front().box, 0u);
  ASSERT_TRUE(low.least_height);
  EXPECT_GT(*low.least_height, 70);
  rules.height = *low.least_height;
  EXPECT_TRUE(check_return(scene, flight({0, 0, 30}, {60, 0, 30}), flier, rules).ok());
}

TEST(CheckReturn, LeavesTheLeastHeightOutWhenItIsNotAsked) {
  const ReturnRules rules{.least_height = false};
  EXPECT_FALSE(
      check_return(scene_of({}), flight({0, 0, 30}, {60, 0, 30}), px4_flier(), rules).least_height);
}

TEST(CheckReturn, OfAPathNeedsASpeedAndHasNoItems) {
  const geom::Polyline points{{0, 0, 30}, {60, 0, 30}};
  EXPECT_TRUE(support::says(
      refusal_of([&] { check_return(scene_of({}), way(points), px4_flier(), {}); }), "--vmax"));
  const geom::Aabb mast{{30, -1, 35}, {31, 1, 50}};
  const ReturnReport report =
      check_return(scene_of({mast}), way(points), px4_flier(), {.height = 60, .speed = 5});
  EXPECT_EQ(report.duration, 12);
  ASSERT_FALSE(report.ok());
  for (const ReturnGap& gap : report.gaps) EXPECT_FALSE(gap.part);
}

TEST(CheckReturn, OfAMissionNamesTheItem) {
  const FileFlight file = mission();
  const ReturnRules rules{.height = 60};
  const ReturnReport clear = check_return(scene_of({}), file, px4_flier(), rules);
  EXPECT_TRUE(clear.ok());
  EXPECT_EQ(clear.autopilot, "px4:1.17");
  const geom::Aabb mast{{60, -9, 45}, {61, 9, 50}};
  const ReturnReport report = check_return(scene_of({mast}), file, px4_flier(), rules);
  ASSERT_FALSE(report.ok());
  for (const ReturnGap& gap : report.gaps) {
    ASSERT_TRUE(gap.part);
    EXPECT_GE(gap.part->item, 1u);
    EXPECT_LE(gap.part->item, 3u);
    EXPECT_EQ(gap.autopilot, "px4:1.17");
  }
}

TEST(CheckReturn, TakesRallyPointsAndFencesOfAMission) {
  FileFlight file = mission();
  auto& flown = std::get<FlownMission>(file.flown.way);
  flown.rally_points = {{60, 30, 10}};
  const geom::Aabb tower{{55, 25, 0}, {65, 35, 90}};
  EXPECT_FALSE(check_return(scene_of({tower}), file, px4_flier(), {}).ok());
  flown.rally_points.clear();
  EXPECT_TRUE(check_return(scene_of({tower}), file, px4_flier(), {}).ok());
  flown.fences = {{false, {{29, -2}, {33, -2}, {31, 2}}, 0}};
  const ReturnReport report = check_return(scene_of({}), file, px4_flier(), {});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.gaps.front().reason, Reason::fence);
}

TEST(CheckReturn, OfDjiNeedsAHeightAndASpeed) {
  EXPECT_TRUE(support::says(refusal(dji(5, {}), {}), "--return-height"));
  EXPECT_TRUE(support::says(refusal(dji({}, 60), {}), "--vmax"));
  const ReturnReport report = check_return(scene_of({}), dji(5, 60), px4_flier(), {});
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.autopilot, "dji");
  EXPECT_EQ(check_return(scene_of({}), dji(5, 60), px4_flier(), {.height = 45}).height, 60)
      << "the file's, to which the aircraft is set";
  FileFlight returning = dji({}, 60);  // a mission that ends with a return
  std::get<FlownMission>(returning.flown.way).speed_before_return = 5;
  EXPECT_TRUE(check_return(scene_of({}), returning, px4_flier(), {}).ok());
  // Which holds needs no height.
  EXPECT_TRUE(
      check_return(scene_of({}), dji(5, {}), px4_flier(), {.action = ReturnAction::hold}).ok());
}

TEST(CheckReturn, OfDjiBeginsOnItsWayDownToo) {
  FileFlight landing = dji(5, 60);
  auto& mission = std::get<FlownMission>(landing.flown.way);
  ASSERT_FALSE(mission.ends.landing_on);
  mission.lands_below = false;
  const double before = check_return(scene_of({}), landing, px4_flier(), {}).duration;
  mission.lands_below = true;
  const ReturnReport report = check_return(scene_of({}), landing, px4_flier(), {.reasons = true});
  EXPECT_GT(report.duration, before + 1);
  ASSERT_FALSE(report.way.empty()) << "for the certificate";
  EXPECT_LT(report.way.back().z(), 1);
}

TEST(CheckReturn, RefusesFilesThatNoAutopilotReturnsFrom) {
  EXPECT_TRUE(support::says(
      refusal(file_of("tello", {FlownLegs{.path = {{0, 0, 5}, {9, 0, 5}}}}), {}), "tello"));
}

TEST(CheckReturn, RefusesAMissionWithoutAHome) {
  FileFlight file = mission();
  std::get<FlownMission>(file.flown.way).home.reset();
  EXPECT_TRUE(support::says(refusal(file, {}), "--home-place"));
  EXPECT_EQ(refusal(file, {.home = Vec3(0, 0, 0)}), "");
}

TEST(CheckReturn, LeavesRoomForNavigation) {
  const geom::Aabb mast{{30, 1.5, 0}, {31, 9, 90}};
  Flier flier = px4_flier();
  EXPECT_TRUE(check_return(scene_of({mast}), flight({0, 0, 30}, {60, 0, 30}), flier, {}).ok());
  flier.navigation = Uncertainty{1.5, 1};
  EXPECT_FALSE(check_return(scene_of({mast}), flight({0, 0, 30}, {60, 0, 30}), flier, {}).ok());
}

}  // namespace
}  // namespace traj
