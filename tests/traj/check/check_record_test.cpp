#include "traj/check/check_record.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

const geom::Aabb kTower{{4, -1, 0}, {6, 1, 20}};

TrajectoryRecord flight(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to) {
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.provenance = geom::provenance_of(scene);
  record.trajectory.segments = {hermite({from}, {to}, 10)};
  return record;
}

geom::PathRecord way(const geom::CollisionScene& scene, geom::Polyline points) {
  geom::PathRecord record{.id = "p1", .status = geom::PathStatus::found};
  record.provenance = geom::provenance_of(scene);
  record.points = std::move(points);
  return record;
}

FileFlight file_of(Flown flown) {
  return {"f1", mission_format_named("tello"), std::move(flown), {}};
}

TEST(CheckRecord, AcceptsAFreeTrajectoryAndRefusesOneThroughABox) {
  const auto scene = scene_of({kTower});
  const auto free = check_record(scene, flight(scene, {0, 5, 5}, {9, 5, 5}), {}, "r", 1);
  EXPECT_TRUE(accepted(free));
  EXPECT_EQ(free.checked, "trajectory");
  EXPECT_EQ(free.id, "q1");
  const auto blocked = check_record(scene, flight(scene, {0, 0, 5}, {9, 0, 5}), {}, "r", 1);
  EXPECT_FALSE(accepted(blocked));
  EXPECT_EQ(blocked.result.reason, Reason::collision);
}

TEST(CheckRecord, AcceptsAFreePathAndRefusesOneThroughABox) {
  const auto scene = scene_of({kTower});
  EXPECT_TRUE(accepted(check_record(scene, way(scene, {{0, 5, 5}, {9, 5, 5}}), {}, "r", 1)));
  const auto blocked = check_record(scene, way(scene, {{0, 0, 5}, {9, 0, 5}}), {}, "r", 1);
  EXPECT_EQ(blocked.result.reason, Reason::collision);
  EXPECT_EQ(blocked.checked, "path");
}

TEST(CheckRecord, HoldsTheVehicleAgainstTheAircraftThatAFileNames) {
  const auto scene = scene_of({kTower});  // of a vehicle that is smaller than any of DJI
  FlownLegs legs;
  legs.path = {{0, 5, 5}, {9, 5, 5}};
  FileFlight file = file_of({legs});
  EXPECT_TRUE(accepted(check_record(scene, file, {}, {})));
  file.vehicle = "m350";
  EXPECT_THROW(check_record(scene, file, {}, {}), geom::InputError);
  const auto insisted = check_record(scene, file, {}, {.override_record = true});
  EXPECT_TRUE(accepted(insisted));
  EXPECT_EQ(insisted.overridden, std::vector<std::string>{"vehicle"});
  const geom::CollisionScene large(scene.map(), {"large", {2, 2, 2}, {}}, 0);
  const auto report = check_record(large, file, {}, {});
  EXPECT_TRUE(accepted(report));
  EXPECT_EQ(report.limits[Limit::speed], 15) << "of the aircraft, where the vehicle has none";
}

TEST(CheckRecord, RefusesWhatHoldsNothingToCheckWithTheReasonOfItsStatus) {
  const auto scene = scene_of({});
  const TrajectoryRecord none{.id = "q1", .status = TrajectoryStatus::infeasible};
  EXPECT_EQ(check_record(scene, none, {}, "r", 1).result.reason,
            reason_of(TrajectoryStatus::infeasible));
  const geom::PathRecord lost{.id = "p1", .status = geom::PathStatus::unreachable};
  EXPECT_EQ(check_record(scene, lost, {}, "r", 1).result.reason, Reason::no_path);
  EXPECT_EQ(unsolved_report(none).checked, "trajectory");
  EXPECT_EQ(unsolved_report(lost).checked, "path");
  EXPECT_FALSE(accepted(unsolved_report(lost)));
}

TEST(CheckRecord, HoldsTheStrictestOfTheLimitsUnlessTheRunOverrides) {
  const auto scene = scene_of({});
  auto record = flight(scene, {0, 0, 5}, {9, 0, 5});
  record.limits[Limit::speed] = 6;
  RecordRules rules{.asked = {{Limit::speed, 8}}, .of_vehicle = Limits{{Limit::speed, 7}}};
  EXPECT_EQ(check_record(scene, record, rules, "r", 1).limits[Limit::speed], 6);
  rules.asked[Limit::speed] = 5;
  EXPECT_EQ(check_record(scene, record, rules, "r", 1).limits[Limit::speed], 5);
  rules.asked[Limit::speed] = 8;
  rules.override_record = true;
  const auto loose = check_record(scene, record, rules, "r", 1);
  EXPECT_EQ(loose.limits[Limit::speed], 8);
  EXPECT_EQ(loose.overridden, std::vector<std::string>{"vmax"});
}

TEST(CheckRecord, SaysThatTheSceneHasLessRoomThanTheRecordAsksFor) {
  const auto scene = scene_of({});
  auto record = way(scene, {{0, 5, 5}, {9, 5, 5}});
  record.provenance.margin = 2;
  const auto report = check_record(scene, record, {}, "r", 1);
  EXPECT_EQ(report.overridden, std::vector<std::string>{"vehicle"});
  EXPECT_EQ(report.provenance.margin, scene.margin());
}

TEST(CheckRecord, RefusesALimitThatAPathGivesNoWayToMeasureIfItWasAskedFor) {
  const auto scene = scene_of({});
  const auto record = way(scene, {{0, 5, 5}, {9, 5, 5}});
  const Limits limits{{Limit::yaw_rate, 1}};
  EXPECT_FALSE(accepted(check_record(scene, record, {.asked = limits}, "r", 1)));
  EXPECT_TRUE(accepted(check_record(scene, record, {.of_vehicle = limits}, "r", 1)));
}

TEST(CheckRecord, ChecksOnceMoreExactlyOnlyIfAsked) {
  const auto scene = scene_of({kTower});
  const auto record = flight(scene, {0, 5, 5}, {9, 5, 5});
  EXPECT_FALSE(check_record(scene, record, {}, "r", 1).exact);
  const auto report = check_record(scene, record, {.exact = true}, "r", 1);
  ASSERT_TRUE(report.exact);
  EXPECT_TRUE(report.exact->ok);
}

TEST(CheckRecord, LeavesTheClearanceOut) {
  const auto scene = scene_of({kTower});
  const auto record = flight(scene, {0, 5, 5}, {9, 5, 5});
  EXPECT_TRUE(check_record(scene, record, {}, "r", 1).result.clearance);
  const RecordRules rules{.clearance = Clearance::left_out};
  EXPECT_FALSE(check_record(scene, record, rules, "r", 1).result.clearance);
}

TEST(CheckRecord, JudgesWhatAFileMakesAVehicleFly) {
  const auto scene = scene_of({kTower});
  FlownLegs legs;
  legs.path = {{0, 5, 5}, {9, 5, 5}};
  const auto free = check_record(scene, file_of({legs}), Flier(), {.exact = true});
  EXPECT_TRUE(accepted(free));
  EXPECT_EQ(free.checked, "path");
  ASSERT_TRUE(free.exact);
  legs.path = {{0, 0, 5}, {9, 0, 5}};
  EXPECT_EQ(check_record(scene, file_of({legs}), Flier(), {}).result.reason, Reason::collision);
}

TEST(CheckRecord, SaysWhatTheProofOfAFileAllowsFor) {
  const auto scene = scene_of({});
  FlownLegs legs;
  legs.path = {{0, 5, 5}, {9, 5, 5}};
  Flier flier;
  flier.navigation = Uncertainty{0.5, 1};
  const auto report = check_record(scene, file_of({legs}), flier, {});
  ASSERT_TRUE(report.navigation);
  EXPECT_EQ((*report.navigation)[0], 0.5);
  EXPECT_EQ((*report.navigation)[1], 1);
}

TEST(CheckRecord, RefusesToCheckACurveOfAFileExactly) {
  const auto scene = scene_of({});
  FlownCurve curve;
  curve.trajectory.segments = {hermite({Vec3(0, 0, 5)}, {Vec3(9, 0, 5)}, 10)};
  EXPECT_THROW(check_record(scene, file_of({curve}), Flier(), {.exact = true}), geom::UsageError);
  EXPECT_EQ(check_record(scene, file_of({curve}), Flier(), {}).checked, "trajectory");
}

TEST(CornerNote, SaysHowCornersWereTakenAndNothingWithoutAny) {
  FlownMission mission;
  mission.path = {{0, 5, 5}, {9, 5, 5}};
  EXPECT_EQ(corner_note({mission}), "");
  EXPECT_EQ(corner_note({FlownLegs()}), "");
  mission.corners = 2;
  mission.acceptance = 1.5;
  EXPECT_TRUE(
      support::says(corner_note({mission}), "2 waypoints: corners were looked at within 1.5 m"));
  mission.acceptance = 0;
  EXPECT_TRUE(support::says(corner_note({mission}), "--acceptance 0"));
}

}  // namespace
}  // namespace traj
