#include "traj/mission/export_mission.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "support/reading.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/read_mission.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// Over flat ground at 0, with boxes in it.
geom::CollisionScene field(std::vector<geom::Aabb> boxes = {}) {
  return testing::scene_of(std::move(boxes), {Vec3(-200, -200, 0), Vec3(200, 200, 90)});
}

// The same for the aircraft that a mission of DJI names, and for no size else.
geom::CollisionScene field_for(const MissionFormat& format, std::vector<geom::Aabb> boxes = {}) {
  const geom::CollisionScene small = field(std::move(boxes));
  const bool dji = &format == &kDjiWpml;
  return {small.map(), {"made for", dji ? vehicle_named("m3e")->vehicle.half : Vec3::Zero()}, 0};
}

// 30 m straight ahead, 20 m up, in 20 s, from rest to rest.
ExportFlight ahead() {
  const Vec3 a(0, 0, 20);
  const Vec3 b(30, 0, 20);
  ExportFlight flight{"ahead", {}};
  flight.trajectory.segments.push_back({20, {a, a, a, a, b, b, b, b}, {}});
  flight.time.epoch = "2026-05-04T06:30:00Z";
  flight.time.start = 12;
  return flight;
}

// What every format finds enough.
ExportOptions options() {
  ExportOptions out;
  out.placement.origin = geom::GeodeticOrigin{47, 8, 400};
  out.placement.ground = 0;
  out.speed = 1;
  out.buffer = 2;
  return out;
}

TEST(ExportMission, EveryFormatHoldsWhatIsFree) {
  for (const MissionFormat* format : mission_formats()) {
    if (!format->write && !format->prove) continue;
    const MissionExport made = export_mission(field_for(*format), ahead(), *format, options());
    ASSERT_TRUE(made.written) << format->format.word << ": " << made.refusal;
    EXPECT_TRUE(made.refusal.empty());
    EXPECT_TRUE(made.result.ok);
    if (!format->read) continue;
    EXPECT_EQ(&recognised_mission_format(made.written->text), format) << format->format.word;
    const auto read =
        read_mission(made.written->text, "f", *format, made.written->reading, geom::Frame{});
    ASSERT_EQ(read.size(), 1u);
    EXPECT_TRUE(judge(field(), read[0].flown, {}).ok) << format->format.word;
  }
}

TEST(ExportMission, NoMissionIsProvedForLessThanTheAircraftThatItNames) {
  const geom::CollisionScene small = testing::scene_of({}, field().map().spec().bounds);
  const MissionExport made = export_mission(small, ahead(), kDjiWpml, options());
  EXPECT_FALSE(made.written);
  EXPECT_NE(made.refusal.find("m3e"), std::string::npos) << made.refusal;
}

// A wall across the way, wherever it stands, is in no format's blind spot.
TEST(ExportMission, NoFormatIsWrittenThroughAWall) {
  testing::Random random(5);
  for (const MissionFormat* format : mission_formats()) {
    if (!format->write && !format->prove) continue;
    for (int i = 0; i < 5; ++i) {
      const double x = random.number(1, 29);
      const geom::CollisionScene walled =
          field_for(*format, {{{x, -199, 0.1}, {x + 0.01, 199, 89}}});
      const MissionExport made = export_mission(walled, ahead(), *format, options());
      EXPECT_FALSE(made.written) << format->format.word << " at " << x;
      EXPECT_FALSE(made.result.ok);
      EXPECT_EQ(made.result.reason, Reason::collision) << format->format.word;
      EXPECT_NE(made.refusal.find("m into obstacle "), std::string::npos) << made.refusal;
    }
  }
}

TEST(ExportMission, TakesATrajectoryAlone) {
  const MissionExport made = export_mission(field(), ahead().trajectory, kCrazyflie);
  ASSERT_TRUE(made.written) << made.refusal;
  EXPECT_EQ(made.written->memory->bytes, 132u);
}

TEST(ExportMission, HoldsTheLimitsOfTheRecord) {
  ExportFlight flight = ahead();
  flight.limits[Limit::speed] = 0.5;
  const MissionExport made = export_mission(field(), flight, kCrazyflie);
  EXPECT_FALSE(made.written);
  EXPECT_EQ(made.result.reason, broken(Limit::speed));
  EXPECT_NE(made.refusal.find("solve it again with stricter limits"), std::string::npos)
      << made.refusal;
}

TEST(ExportMission, SaysWhatAFormatCannotHave) {
  ExportFlight path{"p", {}, {{0, 0, 20}, {9, 0, 20}}};
  EXPECT_EQ(why_unfit(path, kCrazyflie),
            "a crazyflie file has times, and a path has none: make a trajectory of it "
            "(skyway-traj)");
  EXPECT_EQ(why_unfit(path, kGltfLine), "");
  EXPECT_NE(why_unfit(path, kVolume4d), "");
  ExportFlight undated = ahead();
  EXPECT_EQ(why_unfit(undated, kVolume4d), "");
  undated.time.epoch.reset();
  EXPECT_NE(why_unfit(undated, kVolume4d).find("\"epoch\""), std::string::npos);
  EXPECT_EQ(export_mission(field(), path, kCrazyflie).refusal, why_unfit(path, kCrazyflie));
}

TEST(ExportMission, NeedsAnOriginWhereAFileCountsFromOne) {
  EXPECT_THROW(export_mission(field(), ahead(), kWpl), geom::UsageError);
  EXPECT_THROW(export_mission(field(), ahead(), kVolume4d), geom::UsageError);
  EXPECT_TRUE(export_mission(field(), ahead(), kGltfLine).written);
}

TEST(ExportMission, WarnsOfWhatAFileLeavesOut) {
  const auto warned = [](const MissionFormat& format, const ExportOptions& how, const char* what) {
    for (const std::string& one : export_mission(field(), ahead(), format, how).warnings) {
      if (one.find(what) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(warned(kCrazyflie, {}, "does not say when"));
  ExportOptions beside;
  beside.says_when = true;
  EXPECT_FALSE(warned(kCrazyflie, beside, "does not say when"));
  EXPECT_FALSE(warned(kVolume4d, options(), "does not say when"));
  EXPECT_TRUE(warned(kSetpoints, {}, "--tracking"));
  ExportOptions tracking;
  tracking.flier.tracking = Uncertainty{0.1, 0.1};
  EXPECT_FALSE(warned(kSetpoints, tracking, "--tracking"));
}

// A straight line from rest to rest at 1 m/s in the mean, and without a departure.
ExportFlight straight(double metres) {
  const Vec3 a(0, 0, 1);
  const Vec3 b(metres, 0, 1);
  return {"straight", {{{metres, {a, a, a, a, b, b, b, b}, {}}}}};
}

TEST(ExportUnchecked, MarksTablesToo) {
  const auto head_of = [](const MissionFormat& format) {
    const MissionExport made = export_unchecked(straight(30), {}, {}, format);
    EXPECT_TRUE(made.warnings.empty());
    return made.written->text.substr(0, made.written->text.find('\n'));
  };
  EXPECT_TRUE(head_of(kCrazyflie).ends_with(",UNCHECKED: not compared with any map"));
  EXPECT_TRUE(head_of(kSetpoints).ends_with(",unchecked"));
}

// Where no line may say so.
TEST(ExportUnchecked, WarnsOfFilesThatCannotSayIt) {
  for (const MissionFormat* format : {&kWpl, &kTello}) {
    const MissionExport made = export_unchecked(straight(30), {}, {}, *format, options());
    ASSERT_FALSE(made.warnings.empty()) << format->format.word;
    EXPECT_TRUE(support::says(made.warnings.back(), "no room to say that nobody checked it"));
  }
}

// Else a ground station would send what is left of their number in 16 bits.
TEST(ExportUnchecked, WritesNoMissionOfMoreItemsThanMavlinkSends) {
  ExportFlight flight = straight(30);
  for (int i = 0; i < 65540; ++i) flight.path.emplace_back(i % 2, 0, 10);
  EXPECT_THROW(export_unchecked(flight, {}, {}, kWpl, options()), geom::InputError);
  flight.path.resize(1000);
  flight.path.emplace_back(30, 0, 1);
  EXPECT_TRUE(export_unchecked(flight, {}, {}, kWpl, options()).written);
}

TEST(ExportUnchecked, WritesNothingThatItsFormatDoesNotAllow) {
  EXPECT_EQ(export_unchecked(straight(100), {}, {}, kTello).warnings.size(), 1u);
  EXPECT_THROW(export_unchecked(straight(60000), {}, {}, kTello), geom::InputError);
  EXPECT_THROW(export_unchecked(straight(70000), {}, {}, kCrazyflie), geom::InputError);
  const MissionExport near = export_unchecked(straight(0.15), {}, {}, kTello);
  ASSERT_FALSE(near.warnings.empty());
  EXPECT_TRUE(support::says(near.warnings.back(), "ends 0.15 m from the flight's end"));
}

TEST(ExportUnchecked, MarksTheFileAndKnowsNoVolumes) {
  const MissionExport made = export_unchecked(ahead(), {}, {}, kGltfLine);
  ASSERT_TRUE(made.written);
  EXPECT_NE(made.written->text.find("UNCHECKED"), std::string::npos);
  EXPECT_THROW(export_unchecked(ahead(), {}, {}, kVolume4d, options()), geom::UsageError);
  Limits slow;
  slow[Limit::vertical_speed] = 0.5;
  EXPECT_THROW(export_unchecked(ahead(), slow, {}, kDjiWpml, options()), geom::UsageError)
      << "--speed is 1";
}

}  // namespace
}  // namespace traj
