#include "traj/record/check_in_tube.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/flights.h"
#include "traj/record/verdict.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// A way of 3 m at a height of 5 m, with a wall 1 m beside it.
const geom::CollisionScene& scene() {
  static const auto out = testing::scene_of({{Vec3(-10, 1, 0), Vec3(10, 2, 20)}});
  return out;
}

Trajectory flight() {
  Trajectory out = testing::line({3, 0, 0}, 2);
  for (Vec3& p : out.segments[0].point) p.z() += 5;
  return out;
}

TubeRecord tube(double radius, double tilt = 0) {
  TubeRecord out{.radius = std::vector<double>(20, 0.1), .period = 0.1};
  out.radius[11] = radius;
  out.claim = {TubeKind::proved, radius, tilt, ControlLaw::geometric,
               Disturbances{.gust_most = 0.5}};
  return out;
}

TEST(CheckInTube, HoldsTheMapAgainstTheTube) {
  EXPECT_TRUE(check_in_tube(scene(), "a", flight(), tube(0.99), {}).check.clear);
  const TubeReport report = check_in_tube(scene(), "a", flight(), tube(1), {});
  EXPECT_FALSE(report.check.clear);
  EXPECT_EQ(report.check.reason, Reason::collision);
  EXPECT_NEAR(report.check.time, 1.1, 0.011);
}

TEST(CheckInTube, CountsTheTiltThatTheTubeStates) {
  geom::Vehicle vehicle{"quad", geom::attitude_half_sizes({0.5, 0.5, 0.1}, 0)};
  vehicle.limits[geom::Limit::tilt] = 0;
  const geom::CollisionScene quad(scene().map(), vehicle, 0);
  const Vec3 body(0.5, 0.5, 0.1);
  EXPECT_TRUE(check_in_tube(quad, "a", flight(), tube(0.2, 0), body).check.clear);
  // 0.707 m of half a body, and 0.06 m more at this tilt
  EXPECT_TRUE(check_in_tube(quad, "a", flight(), tube(0.285, 0), body).check.clear);
  EXPECT_FALSE(check_in_tube(quad, "a", flight(), tube(0.285, 0.1), body).check.clear);
  const std::string why =
      support::refusal_of([&] { check_in_tube(quad, "a", flight(), tube(0.2, 0.1), {}); });
  EXPECT_TRUE(support::says(why, "found one of 5.73"));
}

TEST(CheckInTube, IsPartOfTheVerdict) {
  ReportRecord report{.id = "a", .checked = "trajectory"};
  report.result.ok = true;
  report.result.duration = 2;
  report.tube = check_in_tube(scene(), "a", flight(), tube(0.5), {});
  EXPECT_TRUE(accepted(report));
  EXPECT_TRUE(support::says(in_words(report, scene().map()),
                            "clear with a tube of at most 0.5 m, proved for "));
  report.tube->claim.kind = TubeKind::statistics;
  EXPECT_FALSE(support::says(in_words(report, scene().map()), "proved for"));
  report.tube = check_in_tube(scene(), "a", flight(), tube(1.5), {});
  EXPECT_FALSE(accepted(report));
  EXPECT_EQ(verdict_word(report), "tube");
  const std::string why = in_words(report, scene().map());
  EXPECT_TRUE(support::says(why, "with a tube of at most 1.5 m, proved for"));
  EXPECT_TRUE(support::says(why, "touches"));
  const ReportSummary read = parse_report_record(to_json_line(report, scene().map()), "report", 1);
  EXPECT_FALSE(read.ok);
  EXPECT_EQ(read.reason, "tube");
  EXPECT_TRUE(read.time && read.place);
}

}  // namespace
}  // namespace traj
