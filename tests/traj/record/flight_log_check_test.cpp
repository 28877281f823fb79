#include "traj/record/flight_log_check.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/record/report_record.h"
#include "traj/record/verdict.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const geom::CollisionScene& scene() {
  static const auto out = testing::scene_of({{Vec3(10, -5, 0), Vec3(11, 5, 20)}});
  return out;
}

// One that stays where it is.
TrajectoryRecord plan(const std::string& id, double seconds) {
  TrajectoryRecord out;
  out.id = id;
  out.status = TrajectoryStatus::solved;
  Segment& segment = out.trajectory.segments.emplace_back();
  segment.duration = seconds;
  segment.point.fill({0, 0, 5});
  return out;
}

FlightLog log(const std::string& id) {
  FlightLog out{.id = id, .map = scene().map().hash()};
  out.samples.push_back({.time = 0, .position = {0, 0, 5}});
  out.samples.push_back({.time = 1, .position = {0, 3, 5}});
  return out;
}

std::string tube(const std::string& id, int periods, const Trajectory& trajectory) {
  std::string radius = "1";
  for (int i = 1; i < periods; ++i) radius += ",1";
  return R"({"type":"flight","id":")" + id +
         R"(","ok":true,"controller":"cascade","monte_carlo":{"tube":{"period":1,"largest":1,)"
         R"("tilt":0.1,"trajectory":")" +
         trajectory_hash(trajectory) + R"(","radius":[)" + radius + "]}}}\n";
}

TEST(FlightLogCheck, HoldsALogAgainstThePlanOfItsId) {
  FlightLogCheck check;
  EXPECT_FALSE(check.judge(log("a"), scene()).plan);
  check.add_plan(plan("a", 1));
  EXPECT_TRUE(check.has_plan(log("other"))) << "there is one alone";
  check.add_plan(plan("b", 1));
  EXPECT_TRUE(check.has_plan(log("b")));
  EXPECT_FALSE(check.has_plan(log("other")));
  const SampledReport report = check.judge(log("a"), scene());
  ASSERT_TRUE(report.plan);
  EXPECT_NEAR(report.plan->furthest.value, 3, 1e-9);
}

TEST(FlightLogCheck, AcceptsALogWithoutAMapOnlyWhereItsRuleSaysSo) {
  FlightLog one = log("a");
  one.map.clear();
  EXPECT_EQ(reason_of(FlightLogCheck({.sampled = true}).judge(one, scene()), scene().map()),
            "no_map");
  const FlightLogCheck lenient({.sampled = true, .any_map = true});
  EXPECT_EQ(reason_of(lenient.judge(one, scene()), scene().map()), "");
}

TEST(FlightLogCheck, AcceptsNoLogOfOnePlace) {
  FlightLog one = log("a");
  one.samples.pop_back();
  for (const SampledRule& rule : {SampledRule{.sampled = true}, SampledRule{.clearance = 1.0}}) {
    const FlightLogCheck check(rule);
    EXPECT_EQ(reason_of(check.judge(log("a"), scene()), scene().map()), "");
    EXPECT_EQ(reason_of(check.judge(one, scene()), scene().map()), "cut");
  }
}

TEST(FlightLogCheck, AcceptsNoLogThatIsShorterThanItsPlan) {
  FlightLogCheck check({.sampled = true});
  check.add_plan(plan("a", 1));
  check.add_plan(plan("b", 1.01));
  EXPECT_EQ(reason_of(check.judge(log("a"), scene()), scene().map()), "");
  const SampledReport cut = check.judge(log("b"), scene());
  EXPECT_EQ(reason_of(cut, scene().map()), "cut");
  EXPECT_TRUE(support::says(in_words(cut, scene().map()), "shorter than its plan"));
}

TEST(FlightLogCheck, NamesPlansThatNoLogIsOf) {
  FlightLogCheck check;
  check.add_plan(plan("a", 1));
  check.add_plan(plan("b", 1));
  const std::vector<FlightLog> logs = {log("b"), log("other")};
  EXPECT_EQ(check.plans_without(logs), std::vector<std::string>{"a"});
}

TEST(FlightLogCheck, LeavesOutPlansWithoutATrajectory) {
  FlightLogCheck check;
  TrajectoryRecord none = plan("a", 1);
  none.status = TrajectoryStatus::no_path;
  check.add_plan(none);
  EXPECT_FALSE(check.has_plans());
}

TEST(FlightLogCheck, TakesTubesThatAreAsLongAsTheirPlan) {
  FlightLogCheck check;
  check.add_plan(plan("a", 3));
  check.read_tubes(support::Text(tube("a", 3, plan("a", 3).trajectory)), "tubes");
  EXPECT_TRUE(check.judge(log("a"), scene()).tube);
  EXPECT_THROW(check.read_tubes(support::Text(tube("a", 2, plan("a", 3).trajectory)), "tubes"),
               geom::InputError);
  EXPECT_THROW(check.read_tubes(support::Text(tube("b", 3, plan("a", 3).trajectory)), "tubes"),
               geom::InputError);
}

TEST(FlightLogCheck, WantsATubeOfEachPlan) {
  FlightLogCheck check;
  check.add_plan(plan("a", 3));
  check.add_plan(plan("b", 3));
  const std::string of_a = tube("a", 3, plan("a", 3).trajectory);
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { check.read_tubes(support::Text(of_a), "tubes"); }),
                    "tubes: expected a tube of each trajectory, found none of \"b\""));
  const std::string of_both = of_a + tube("b", 3, plan("b", 3).trajectory);
  check.read_tubes(support::Text(of_both), "tubes");
  EXPECT_TRUE(check.judge(log("b"), scene()).tube);
}

TEST(FlightLogCheck, ReportsAreOfTheLogWithTheirNumbers) {
  FlightLog flown = log("a");
  const std::string line = to_json_line(FlightLogCheck().judge(flown, scene()), scene().map());
  const ReportSummary report = parse_report_record(line, "r", 1);
  EXPECT_FALSE(why_not_of(report, flown));
  flown.samples[1].position.y() = 2;
  const auto why = why_not_of(report, flown);
  ASSERT_TRUE(why);
  EXPECT_EQ(why->found, "one of another: its samples are others");
}

TEST(FlightLogCheck, JudgesByItsRule) {
  const SampledReport strict = FlightLogCheck().judge(log("a"), scene());
  EXPECT_EQ(reason_of(strict, scene().map()), "sampled");
  EXPECT_TRUE(support::says(in_words(strict, scene().map()), "--require-clearance"));
  const SampledReport lenient = FlightLogCheck({.sampled = true}).judge(log("a"), scene());
  EXPECT_EQ(reason_of(lenient, scene().map()), "");
  EXPECT_TRUE(support::says(in_words(lenient, scene().map()), "up to 1 s, was not measured"));
}

}  // namespace
}  // namespace traj
