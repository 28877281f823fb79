#include "traj/record/tube_reports.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/flights.h"
#include "traj/record/flight_report.h"
#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

TrajectoryRecord plan(const std::string& id, const Vec3& to = {3, 0, 0}) {
  TrajectoryRecord out;
  out.id = id;
  out.status = TrajectoryStatus::solved;
  out.trajectory = testing::line(to, 0.95);
  return out;
}

const geom::Vehicle kQuad{"quad", {0.3, 0.3, 0.2}};
const geom::Provenance kOver{.frame = geom::Axes::enu, .vehicle = kQuad};

FlightReport report_of(const TrajectoryRecord& flown, std::size_t periods = 10) {
  FlightReport report{.id = flown.id, .duration = 0.95};
  report.trajectory = trajectory_hash(flown.trajectory);
  report.disturbances = Disturbances{.gust_most = 0.5};
  report.proved.radius.assign(periods, 0.03);
  report.proved.largest = 0.03;
  report.provenance.vehicle = kQuad;
  return report;
}

TubeReports read(const std::string& text) {
  return TubeReports::read(support::Text(text), "tubes");
}

std::string refusal(const FlightReport& report, const TrajectoryRecord& record,
                    const geom::Provenance& over = kOver) {
  const TubeReports tubes = read(to_json_line(report, {}, nullptr));
  return support::refusal_of([&] { tubes.tube_of(record.id, record.trajectory, over); });
}

TEST(TubeReports, GivesTheTubeOfATrajectory) {
  const TubeReports tubes = read(to_json_line(report_of(plan("a")), {}, nullptr) +
                                 "{\"type\":\"flight\",\"id\":\"none\"}\n");
  ASSERT_TRUE(tubes.tube_of("a", plan("a").trajectory, kOver));
  EXPECT_EQ(tubes.tube_of("a", plan("a").trajectory, kOver)->radius.size(), 10u);
  EXPECT_FALSE(tubes.tube_of("none", plan("none").trajectory, kOver));
  EXPECT_FALSE(tubes.tube_of("b", plan("b").trajectory, kOver));
  EXPECT_TRUE(support::says(
      support::refusal_of([&] { tubes.require_tube("b", plan("b").trajectory, kOver); }),
      "found none of \"b\""));
}

TEST(TubeReports, RefuseTheTubeOfAnother) {
  const FlightReport report = report_of(plan("a"));
  EXPECT_EQ(refusal(report, plan("a")), "");
  EXPECT_TRUE(support::says(refusal(report, plan("a", {3, 1e-9, 0})),
                            "tubes:1: expected a tube of the tr"));
  EXPECT_TRUE(support::says(refusal(report, plan("a"), {.frame = geom::Axes::neu}), "axes neu"));
  geom::Provenance other = kOver;
  other.vehicle->half.x() = 0.31;
  EXPECT_TRUE(support::says(refusal(report, plan("a"), other), "half sizes [0.31, "));
  other.vehicle = geom::Vehicle{"other", kQuad.half};
  EXPECT_TRUE(support::says(refusal(report, plan("a"), other), "\"other\""));
  FlightReport nobody = report;
  nobody.provenance.vehicle.reset();
  EXPECT_TRUE(support::says(refusal(nobody, plan("a")), "found none"));
}

// Of runs, too.
TEST(TubeReports, RefuseATubeOfNobodyKnowsWhichVehicle) {
  const TubeReports tubes =
      read(R"({"type":"flight","id":"a","controller":"cascade","monte_carlo":{"tube":{"period":1,)"
           R"("largest":0.3,"tilt":0.2,"trajectory":")" +
           trajectory_hash(plan("a").trajectory) +
           R"(","radius":[0.3]}}})"
           "\n");
  EXPECT_TRUE(support::says(
      support::refusal_of([&] { tubes.tube_of("a", plan("a").trajectory, kOver); }), "found none"));
  EXPECT_TRUE(tubes.tube_of("a", plan("a").trajectory, {.frame = geom::Axes::enu}));
}

TEST(TubeReports, RefuseATubeThatIsShorterOrLongerThanItsTrajectory) {
  for (const std::size_t periods : {1, 9, 11}) {
    EXPECT_TRUE(support::says(refusal(report_of(plan("a"), periods), plan("a")), "for the 0.95 s"))
        << periods;
  }
}

TEST(TubeReports, RefuseAProofThatWasRefused) {
  FlightReport report = report_of(plan("a"));
  report.proved.trouble = TubeTrouble{.kind = TubeTrouble::Kind::unstable};
  const std::string why = refusal(report, plan("a"));
  EXPECT_TRUE(
      support::says(why,
                    "tubes:1: expected a tube that is proved, found a proof that was refused "
                    "(unstable)"));
}

TEST(TubeReports, RefuseASecondTubeOfOneFlight) {
  const std::string line = to_json_line(report_of(plan("a")), {}, nullptr);
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(line + line); }), "tubes:2"));
}

}  // namespace
}  // namespace traj
