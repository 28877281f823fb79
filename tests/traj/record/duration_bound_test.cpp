#include "traj/record/duration_bound.h"

#include <gtest/gtest.h>

#include "solve/stop_and_go.h"
#include "traj/record/report_record.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const Limits kLimits{{Limit::speed, 8}, {Limit::acceleration, 6}};

geom::Provenance origin() {
  return {"sha256:0", geom::Axes::enu, geom::Vehicle{"box", Vec3::Ones()}, 0.0};
}

geom::PathRecord path() {
  geom::PathRecord record;
  record.id = "q";
  record.status = geom::PathStatus::found;
  record.points = {{0, 0, 0}, {30, 0, 0}, {30, 40, 0}};
  record.provenance = origin();
  record.bound = 69;
  return record;
}

TrajectoryRecord flown(const geom::PathRecord& path) {
  TrajectoryRecord record;
  record.id = path.id;
  record.status = TrajectoryStatus::solved;
  record.trajectory = stop_and_go(path.points, kLimits);
  record.provenance = origin();
  record.limits = kLimits;
  return record;
}

TrajectoryRecord bounded() {
  TrajectoryRecord record = flown(path());
  add_bounds(path(), record);
  return record;
}

TEST(DurationBound, FollowsFromThePathsBoundOnLength) {
  const TrajectoryRecord record = bounded();
  ASSERT_TRUE(record.bound && record.duration_bound);
  EXPECT_EQ(record.bound, 69);
  EXPECT_NEAR(*record.duration_bound, 69.0 / 8 + 8.0 / 6, 1e-12);
  EXPECT_LE(*record.duration_bound, duration(record.trajectory));
  EXPECT_FALSE(claims_too_much(record));
}

TEST(DurationBound, StandsOnTheLimitsOfTheVehicleToo) {
  TrajectoryRecord record = flown(path());
  record.provenance.vehicle->limits[Limit::vertical_speed] = 1;
  record.provenance.vehicle->limits[Limit::speed] = 2;
  add_bounds(path(), record);
  EXPECT_NEAR(*record.duration_bound, 69.0 / 2 + 2.0 / 6, 1e-12);
}

TEST(DurationBound, ComesBackFromTheRecord) {
  const std::string line = to_json_line(bounded());
  const TrajectoryRecord back = parse_trajectory_record(line, "t", 1);
  EXPECT_EQ(back.bound, bounded().bound);
  EXPECT_EQ(back.duration_bound, bounded().duration_bound);
  EXPECT_EQ(to_json_line(back), line);
}

// A bound is of one map, frame, vehicle, margin and pair of ends.
TEST(DurationBound, IsNotInheritedByWhatItDoesNotHoldFor) {
  const auto inherits = [](const geom::PathRecord& path, TrajectoryRecord record) {
    add_bounds(path, record);
    return record.bound || record.duration_bound;
  };
  EXPECT_TRUE(inherits(path(), flown(path())));
  geom::PathRecord other = path();
  other.points.front() += Vec3(1e-12, 0, 0);
  EXPECT_FALSE(inherits(other, flown(path())));
  other = path();
  other.points.back().z() = 1e-12;
  EXPECT_FALSE(inherits(other, flown(path())));
  other = path();
  other.bound.reset();
  EXPECT_FALSE(inherits(other, flown(path())));
  other = path();
  other.bound = 71;  // longer than the path itself
  EXPECT_FALSE(inherits(other, flown(path())));
  for (int what = 0; what < 4; ++what) {
    other = path();
    if (what == 0) other.provenance.map = "sha256:1";
    if (what == 1) other.provenance.margin = 0.5;
    if (what == 2) other.provenance.vehicle->half.x() = 2;
    if (what == 3) other.provenance = {};  // of nobody knows what
    EXPECT_FALSE(inherits(other, flown(path()))) << what;
  }
  TrajectoryRecord none = flown(path());
  none.status = TrajectoryStatus::infeasible;
  EXPECT_FALSE(inherits(path(), none));
}

TEST(DurationBound, IsNoneWhereAnEndMoves) {
  for (const bool at_end : {false, true}) {
    TrajectoryRecord record = bounded();
    auto& segments = record.trajectory.segments;
    (at_end ? segments.back().point[6] : segments.front().point[1]) += Vec3(0.1, 0, 0);
    EXPECT_FALSE(duration_bound(record, kLimits));
    EXPECT_TRUE(claims_too_much(record));  // it has one all the same
  }
}

TEST(DurationBound, IsNotBelieved) {
  TrajectoryRecord record = bounded();
  record.duration_bound = *record.duration_bound * (1 + 1e-15);
  EXPECT_TRUE(claims_too_much(record));  // more than follows
  record = bounded();
  record.duration_bound = 1;  // less: true, if weak
  EXPECT_FALSE(claims_too_much(record));
  record.bound.reset();
  EXPECT_TRUE(claims_too_much(record));  // it follows from nothing
  record = bounded();
  record.bound = 71;  // the curve itself has 70 m
  record.duration_bound.reset();
  EXPECT_TRUE(claims_too_much(record));
  record = bounded();
  record.limits[Limit::speed] = 80;  // what it was made for was stricter
  EXPECT_TRUE(claims_too_much(record));
  record = bounded();
  for (Segment& s : record.trajectory.segments) s.duration /= 2;
  EXPECT_TRUE(claims_too_much(record));  // it is faster than any
}

ReportRecord report_of(const TrajectoryRecord& record, const Limits& held) {
  ReportRecord report{record.id, "trajectory", {}, origin(), held, {}, {}};
  report.result.ok = true;
  report.result.looked = true;
  report.result.duration = duration(record.trajectory);
  return report;
}

TEST(DurationBound, OfAReportIsForTheLimitsThatWereHeld) {
  const TrajectoryRecord record = bounded();
  ReportRecord report = report_of(record, kLimits);
  add_bounds(record, report);
  EXPECT_TRUE(accepted(report));
  EXPECT_EQ(report.claimed_bound, 69);
  EXPECT_EQ(report.duration_bound, record.duration_bound);
  report = report_of(record, {{Limit::speed, 5}, {Limit::acceleration, 6}});
  add_bounds(record, report);
  EXPECT_NEAR(*report.duration_bound, 69.0 / 5 + 5.0 / 6, 1e-12);
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, {});
  EXPECT_EQ(parse_report_record(to_json_line(report, map), "r", 1).duration_bound,
            report.duration_bound);
}

TEST(DurationBound, OfAReportIsNoneWhereItDoesNotHold) {
  const TrajectoryRecord record = bounded();
  ReportRecord loose = report_of(record, kLimits);
  loose.overridden = {"vmax"};
  add_bounds(record, loose);
  EXPECT_TRUE(accepted(loose));
  EXPECT_FALSE(loose.claimed_bound || loose.duration_bound);
  ReportRecord larger = report_of(record, kLimits);
  larger.provenance.margin = 1;
  add_bounds(record, larger);
  EXPECT_FALSE(larger.claimed_bound || larger.duration_bound);
  ReportRecord failed = report_of(record, kLimits);
  failed.result.ok = false;
  failed.result.reason = broken(Limit::speed);
  add_bounds(record, failed);
  EXPECT_EQ(failed.result.reason, broken(Limit::speed));
  EXPECT_FALSE(failed.claimed_bound || failed.duration_bound);
}

TEST(DurationBound, OfAReportIsRefusedWhereTheRecordLies) {
  TrajectoryRecord record = bounded();
  record.duration_bound = *record.duration_bound * 1.001;
  ReportRecord report = report_of(record, kLimits);
  add_bounds(record, report);
  EXPECT_FALSE(accepted(report));
  EXPECT_EQ(report.result.reason, Reason::duration_bound);
  EXPECT_EQ(report.result.worst, *record.duration_bound);
  EXPECT_FALSE(report.claimed_bound || report.duration_bound);
}

// Its control points reach further than its curve, whose length is what counts.
TEST(DurationBound, OnLengthIsHeldAgainstTheCurveNotItsControlPoints) {
  TrajectoryRecord record;
  record.status = TrajectoryStatus::solved;
  Segment& s = record.trajectory.segments.emplace_back();
  s.duration = 6;
  const double x[] = {0, 0, 30, -20, 30, -20, 10, 10};
  for (std::size_t i = 0; i < s.point.size(); ++i) s.point[i] = {x[i], 0, 0};
  double length = 0;
  for (int i = 1; i <= 10000; ++i) {
    length += (evaluate(s, 6e-4 * i).position - evaluate(s, 6e-4 * (i - 1)).position).norm();
  }
  record.bound = length * (1 - 1e-6);
  EXPECT_FALSE(claims_too_much(record));
  record.bound = length * (1 + 1e-5);
  EXPECT_TRUE(claims_too_much(record));
}

TEST(DurationBound, ThatFollowsAndIsUndercutIsRefused) {
  TrajectoryRecord record = bounded();
  record.duration_bound.reset();
  EXPECT_FALSE(claims_too_much(record));
  record.limits[Limit::speed] = 2;
  EXPECT_TRUE(claims_too_much(record)) << "34 s at least, by its own limits";
  record.limits = kLimits;
  EXPECT_TRUE(claims_too_much(record, {{Limit::speed, 2}}));
}

TEST(DurationBound, OfAPathIsRefusedWhereItIsLongerThanThePath) {
  geom::PathRecord record = path();
  ReportRecord report{"q", "path", {}, {}, {}, {}, {}};
  report.result.ok = true;
  add_bounds(record, report);
  EXPECT_TRUE(accepted(report));
  record.bound = 71;
  add_bounds(record, report);
  EXPECT_FALSE(accepted(report));
  EXPECT_EQ(report.result.reason, Reason::duration_bound);
  EXPECT_EQ(report.result.worst, 71);
}

TEST(DurationBound, InWordsIsRoundedUp) {
  EXPECT_EQ(slower_words(0.0312), "at most 3.2 % slower than any");
  EXPECT_EQ(slower_words(0.03), "at most 3.0 % slower than any");
  EXPECT_EQ(slower_words(1e-6), "at most 0.1 % slower than any");
  EXPECT_EQ(slower_words(0), "at most 0.0 % slower than any");
}

}  // namespace
}  // namespace traj
