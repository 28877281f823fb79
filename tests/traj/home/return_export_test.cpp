#include "traj/home/return_export.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "geom/record/record.h"
#include "geom/record/volume4d.h"
#include "support/reading.h"
#include "support/small_map.h"
#include "traj/mission/firmware/autopilot_settings.h"
#include "traj/mission/formats/fence_file.h"
#include "traj/mission/formats/qgc_plan.h"
#include "traj/mission/formats/wpl.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/read_mission.h"

namespace traj {
namespace {

using geom::Aabb;
using support::says;
using support::Text;

// A field of 600 m with boxes on it, for a vehicle of a metre with a margin of 0.6 m.
geom::CollisionScene field(std::vector<Aabb> boxes = {}) {
  return {support::map_of({{-300, -300, 0}, {300, 300, 150}}, std::move(boxes)),
          {"cube", Vec3(0.5, 0.5, 0.3), {}},
          0.6};
}

const std::vector<Aabb> kTowers = {{{40, 20, 0}, {60, 40, 100}}, {{-60, 30, 0}, {-40, 60, 20}}};

ExportFlight around() {
  geom::PathRecord record;
  record.id = "q1";
  record.status = geom::PathStatus::found;
  record.points = {{0, 0, 20}, {100, 0, 20}, {100, 80, 20}};
  return export_flight(record);
}

ExportOptions options(const char* autopilot = "px4:1.17") {
  ExportOptions out;
  out.placement.origin = geom::GeodeticOrigin{47, 8, 400};
  out.placement.ground = 0;
  out.speed = 5;
  out.flier.autopilots = *autopilots_of(autopilot);
  return out;
}

ReturnWishes at(double height) {
  ReturnWishes wishes;
  wishes.height = height;
  return wishes;
}

std::string refusal_of(const ReturnWishes& wishes, const geom::CollisionScene& scene = field()) {
  const MissionExport made = export_with_return(scene, around(), kQgcPlan, options(), wishes);
  EXPECT_EQ(made.written.has_value(), made.refusal.empty());
  return made.refusal;
}

bool contains(const std::vector<std::string>& texts, const std::string& what) {
  for (const std::string& text : texts) {
    if (text.find(what) != std::string::npos) return true;
  }
  return false;
}

FlownMission read_back(const WrittenMission& written, const MissionFormat& format,
                       const Flier& flier) {
  MissionReading reading = written.reading;
  reading.flier = flier;
  auto read = read_mission(written.text, "f", format, reading, geom::Frame{});
  return std::get<FlownMission>(read.front().flown.way);
}

TEST(ExportWithReturn, CompilesFencesIntoAPlan) {
  ReturnWishes wishes = at(60);
  wishes.compiles_fences = true;
  const auto scene = field(kTowers);
  const MissionExport made = export_with_return(scene, around(), kQgcPlan, options(), wishes);
  ASSERT_TRUE(made.written) << made.refusal;
  const auto fences = read_qgc_fences(Text(made.written->text), "f");
  ASSERT_FALSE(fences.empty());
  EXPECT_TRUE(fences.front().inclusion);
  FlownMission mission = read_back(*made.written, kQgcPlan, options().flier);
  EXPECT_EQ(mission.fences.size(), fences.size());
  EXPECT_TRUE(judge(scene, {mission}, {}).ok);
  mission.fences.front().ring = {{-10, -10}, {90, -10}, {90, 90}, {-10, 90}};
  EXPECT_EQ(judge(scene, {mission}, {}).reason, Reason::fence);
}

TEST(ExportWithReturn, WritesFencesAndRallyPointsOfWplBesideTheMission) {
  ReturnWishes wishes = at(60);
  wishes.compiles_fences = true;
  wishes.rally = {{100, -30, 10}};
  const MissionExport made = export_with_return(field(kTowers), around(), kWpl, options(), wishes);
  ASSERT_TRUE(made.written) << made.refusal;
  EXPECT_FALSE(says(made.written->text, "5001"));
  EXPECT_TRUE(is_fence_text(made.written->fences)) << made.written->fences;
  EXPECT_FALSE(read_fences(Text(made.written->fences), "f").empty());
  const auto places = read_wpl_rally(Text(made.written->rally), "f");
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places.front().height, 10);
}

TEST(ExportWithReturn, WritesRallyPointsIntoAPlan) {
  ReturnWishes wishes = at(60);
  wishes.rally = {{100, -30, 10}, {-20, -20, 15}};
  const MissionExport made = export_with_return(field(), around(), kQgcPlan, options(), wishes);
  ASSERT_TRUE(made.written) << made.refusal;
  const FlownMission mission = read_back(*made.written, kQgcPlan, options().flier);
  ASSERT_EQ(mission.rally_points.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((mission.rally_points[i] - wishes.rally[i]).norm(), 0.02);
  }
}

TEST(ExportWithReturn, RefusesRallyPointsWhereNobodyCanLand) {
  const auto with = [](const Vec3& place, std::vector<Aabb> boxes = kTowers) {
    ReturnWishes wishes = at(20);
    wishes.rally = {{100, -30, 10}, place};
    return refusal_of(wishes, field(std::move(boxes)));
  };
  EXPECT_EQ(with({50, 30, 50}), "rally point 2 is inside of obstacle 1");
  EXPECT_TRUE(says(with({0, 0, 149.9}), "above the map's ceiling"));
  EXPECT_EQ(with({310, 0, 20}), "rally point 2 is outside of the map's bounds");
  EXPECT_TRUE(says(with({-50, 40, 40}), "no level ground as high as home's")) << "on a roof";
  EXPECT_TRUE(says(with({39.3, 30, 110}), "no level ground")) << "half on a roof";
  EXPECT_EQ(with({30, -30, 20}), "");
}

TEST(ExportWithReturn, RefusesRallyPointsOutsideOfAFence) {
  ReturnWishes wishes = at(60);
  wishes.fences = read_fences(Text("QGC WPL 110\n0\t1\t3\t5003\t140\t0\t0\t0\t47\t8\t0\t1\n"), "f");
  wishes.rally = {{50, -30, 10}};
  EXPECT_EQ(refusal_of(wishes), "");
  wishes.rally = {{150, -30, 10}};
  EXPECT_EQ(refusal_of(wishes), "rally point 1 is outside of a fence, or too near to it");
}

TEST(ExportWithReturn, RefusesAReturnAboveTheCeiling) {
  EXPECT_EQ(refusal_of(at(140)), "");
  EXPECT_TRUE(says(refusal_of(at(149.5)), "above the map's ceiling at 150"));
}

TEST(ExportWithReturn, RefusesAMissionThatLeavesAFence) {
  ReturnWishes wishes = at(60);
  wishes.fences = read_fences(Text("QGC WPL 110\n0\t1\t3\t5003\t90\t0\t0\t0\t47\t8\t0\t1\n"), "f");
  EXPECT_TRUE(says(refusal_of(wishes), "fence"));
}

TEST(ExportWithReturn, KeepsTheBudgetOfCorners) {
  ReturnWishes wishes = at(60);
  wishes.compiles_fences = true;
  wishes.budget = 3;
  EXPECT_TRUE(says(refusal_of(wishes, field(kTowers)), "corners were needed, and 3"));
  wishes.compiles_fences = false;
  wishes.fences = read_fences(Text("QGC WPL 110\n0\t1\t3\t5003\t200\t0\t0\t0\t47\t8\t0\t1\n"
                                   "1\t0\t3\t5003\t201\t0\t0\t0\t47\t8\t0\t1\n"
                                   "2\t0\t3\t5003\t202\t0\t0\t0\t47\t8\t0\t1\n"
                                   "3\t0\t3\t5003\t203\t0\t0\t0\t47\t8\t0\t1\n"),
                              "f");
  EXPECT_TRUE(says(refusal_of(wishes), "4 corners, and 3"));
}

TEST(ExportWithReturn, SaysFromWhichTimesNoReturnIsProved) {
  const std::vector<Aabb> wall = {{{40, 20, 0}, {60, 40, 100}}};
  const ExportOptions asked = options("ardupilot:4.6");
  const MissionExport low = export_with_return(field(wall), around(), kQgcPlan, asked, at(60));
  ASSERT_TRUE(low.written) << low.refusal;
  EXPECT_TRUE(contains(low.warnings, "its return is proved for"));
  const MissionExport high = export_with_return(field(wall), around(), kQgcPlan, asked, at(110));
  ASSERT_TRUE(high.written) << high.refusal;
  EXPECT_FALSE(contains(high.warnings, "its return is proved for"));
  EXPECT_TRUE(contains(high.warnings, "set RTL_ALT to 110 m"));
}

TEST(ExportWithReturn, WritesParametersThatReadBack) {
  for (const char* word : {"px4:1.17", "px4", "ardupilot:4.6", "ardupilot:4.7", "ardupilot"}) {
    ReturnWishes wishes = at(47.333);
    wishes.params = true;
    const ExportOptions asked = options(word);
    const MissionExport made = export_with_return(field(), around(), kQgcPlan, asked, wishes);
    ASSERT_TRUE(made.written) << made.refusal;
    const auto read = set_autopilot(read_autopilot_settings(Text(made.written->params), "p"),
                                    asked.flier.autopilots, "p");
    EXPECT_GE(read.autopilot.return_height, 47.333) << word;
    EXPECT_LT(read.autopilot.return_height, 47.344) << word;
  }
}

TEST(ExportWithReturn, NeedsOneAutopilotForParameters) {
  ReturnWishes wishes;
  wishes.params = true;
  EXPECT_THROW(export_with_return(field(), around(), kQgcPlan, options("any"), wishes),
               geom::UsageError);
}

TEST(ExportWithReturn, RefusesFormatsThatHoldNoReturn) {
  for (const MissionFormat* format : {&kKml, &kTello, &kCrazyflie, &kDjiWpml}) {
    EXPECT_THROW(export_with_return(field(), around(), *format, options(), at(60)),
                 geom::UsageError);
  }
}

TEST(ExportWithReturn, TellsTheProcedureInWords) {
  ReturnWishes wishes = at(60);
  wishes.procedure = true;
  wishes.compiles_fences = true;
  wishes.rally = {{100, -30, 10}};
  const MissionExport made =
      export_with_return(field(kTowers), around(), kQgcPlan, options(), wishes);
  ASSERT_TRUE(made.written) << made.refusal;
  const std::string& text = made.written->procedure;
  for (const char* part :
       {"Lost-link procedure of flight q1", "climbs to 60 m above home", "Home: latitude 47.00000",
        "Rally point 1: latitude", "The vehicle stays within", "Times without a proved return",
        "sha256:", "px4:1.17", "What is not proved"}) {
    EXPECT_TRUE(says(text, part)) << part << " in\n" << text;
  }
}

TEST(ExportWithReturn, AddsOffNominalVolumes) {
  ExportFlight flight{"ahead", {}};
  const Vec3 a(0, 0, 20);
  const Vec3 b(80, 0, 20);
  flight.trajectory.segments.push_back({20, {a, a, a, a, b, b, b, b}, {}});
  flight.time.epoch = "2026-05-04T06:30:00Z";
  flight.time.start = 12;
  ReturnWishes wishes = at(60);
  wishes.off_nominal = 4;
  const MissionExport plain =
      export_with_return(field(), flight, kVolume4d, options(), ReturnWishes{});
  const MissionExport made = export_with_return(field(), flight, kVolume4d, options(), wishes);
  ASSERT_TRUE(made.written) << made.refusal;
  const geom::IntentVolumes read = geom::read_intent_volumes(Text(made.written->text), "f");
  EXPECT_EQ(read.nominal.size(), geom::read_volumes_4d(Text(plain.written->text), "f").size());
  ASSERT_FALSE(read.off_nominal.empty());
  EXPECT_LE(read.off_nominal.size(), 4u);
  for (const geom::Volume4d& volume : read.off_nominal) {
    EXPECT_GT(*volume.upper, 460) << "as high as it returns";
    EXPECT_LE(*volume.lower, 400) << "down to the ground";
  }
}

}  // namespace
}  // namespace traj
