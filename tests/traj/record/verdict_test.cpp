#include "traj/record/verdict.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace traj {
namespace {

constexpr auto npos = std::string::npos;

ReportRecord refused(Reason reason, double worst = 0.5) {
  ReportRecord out{"a", "trajectory", {}, {}, {}, {}, {}};
  out.result.reason = reason;
  out.result.looked = true;
  out.result.worst = worst;
  out.result.time = 3.25;
  out.result.place = {1, 2, 3};
  out.result.box = 0;
  return out;
}

class Verdict : public ::testing::Test {
 protected:
  std::string said(const ReportRecord& report) const { return in_words(report, city_); }

  const geom::BoxMap city_ = support::random_city(1, 3, 50);
};

// Every reason, in every kind of record, whatever its number is.
TEST_F(Verdict, HasASentenceForEachReason) {
  std::vector<std::string> faults;
  for (const auto& [reason, word] : kReasonWords) {
    if (reason == Reason::none) continue;
    for (const double worst : {0.0, 0.5, -0.5, 1e9, std::nan("")}) {
      for (const char* checked : {"trajectory", "path"}) {
        ReportRecord report = refused(reason, worst);
        report.checked = checked;
        const std::string sentence = said(report);
        EXPECT_GT(sentence.size(), 20u) << word;
        EXPECT_EQ(sentence.find_first_of("{}\"\n_"), npos) << word << ": " << sentence;
        EXPECT_NE(sentence.find(' '), npos) << word;
      }
    }
    faults.push_back(fault_in_words(refused(reason).result, city_));
  }
  std::sort(faults.begin(), faults.end());
  for (std::size_t i = 1; i < faults.size(); ++i) EXPECT_NE(faults[i - 1], faults[i]);
}

TEST_F(Verdict, SaysWhatIsHitWhenAndWhere) {
  const std::string sentence = said(refused(Reason::collision, 0.413));
  const std::string obstacle = "obstacle " + std::to_string(city_.ids()[0]);
  EXPECT_TRUE(sentence.starts_with("the vehicle reaches 0.413 m into " + obstacle)) << sentence;
  EXPECT_NE(sentence.find(" at 3.25 s, near [1.000, 2.000, 3.000]; "), npos) << sentence;
}

TEST_F(Verdict, CountsLegsOfAPathAndItemsOfAMission) {
  ReportRecord path = refused(Reason::collision);
  path.checked = "path";
  EXPECT_NE(said(path).find(" on leg 3, near"), npos) << said(path);
  path.result.part = FlightPart{7, Manoeuvre::landing};
  EXPECT_NE(said(path).find(" at item 7 (landing), near"), npos) << said(path);
}

TEST_F(Verdict, SaysWhatALimitIsBesideWhatWasFound) {
  ReportRecord fast = refused(broken(Limit::speed), 9);
  fast.limits[Limit::speed] = 8;
  EXPECT_TRUE(said(fast).starts_with("the speed is 9 m/s, above its limit of 8 m/s")) << said(fast);
  EXPECT_NE(said(fast).find("--vmax"), npos) << said(fast);
}

TEST_F(Verdict, NamesTheSideOfTheBoundsThatIsLeft) {
  const geom::Aabb& bounds = city_.spec().bounds;
  const geom::Vec3 middle = 0.5 * (bounds.min + bounds.max);
  const auto left = [&](int axis, double side) {
    ReportRecord out = refused(Reason::bounds);
    out.result.place = middle;
    out.result.place[axis] = side;
    return said(out);
  };
  EXPECT_NE(left(2, bounds.max.z() + 1).find("(ceiling of "), npos);
  EXPECT_NE(left(2, bounds.min.z() - 1).find("(floor of "), npos);
  EXPECT_NE(left(0, bounds.min.x() - 1).find("(lower x of "), npos);
  EXPECT_NE(left(1, bounds.max.y() + 1).find("(upper y of "), npos);
}

// A vehicle may be inside with its middle, and outside with its box.
TEST_F(Verdict, CountsTheVehicleWhenItNamesTheSide) {
  ReportRecord report = refused(Reason::bounds);
  report.provenance.vehicle = geom::Vehicle{.half = {9, 1, 1}};
  const geom::Aabb& bounds = city_.spec().bounds;
  report.result.place = 0.5 * (bounds.min + bounds.max);
  report.result.place.x() = bounds.max.x() - 5;
  report.result.place.z() = bounds.max.z() - 2;
  EXPECT_NE(said(report).find("(upper x of "), npos) << said(report);
}

TEST_F(Verdict, SaysOfAnAcceptedRecordHowClearItIs) {
  ReportRecord report{"a", "trajectory", {}, {}, {}, {}, {}};
  report.result.ok = report.result.looked = true;
  report.result.duration = 69.2;
  report.result.clearance = Extreme{0.52348, 12.5};
  EXPECT_EQ(said(report), "clear for 69.2 s, at least 0.5224 m from every obstacle (at 12.5 s)");
  report.limits[Limit::jerk] = 5;
  report.overridden = {"vmax"};
  EXPECT_NE(said(report).find("; not measured: jerk"), npos);
  EXPECT_NE(said(report).find("(--override or --spare): vmax"), npos);
  EXPECT_EQ(verdict_word(report), "ok");
}

// A clearance is known to 1 mm on a curve, and to rounding on a straight leg.
TEST_F(Verdict, SaysNoMoreRoomThanThereIs) {
  ReportRecord report{"a", "trajectory", {}, {}, {}, {}, {}};
  report.result.ok = report.result.looked = true;
  report.result.duration = 9;
  report.result.clearance = Extreme{0.0009, 1};
  EXPECT_NE(said(report).find("at least 0 m from"), npos) << said(report);
  report.checked = "path";
  report.result.duration = 0;
  report.result.clearance = Extreme{123.49, 1};
  EXPECT_NE(said(report).find("at least 123.4 m from"), npos) << said(report);
}

TEST_F(Verdict, SaysWhatAMissionsYesRestsOn) {
  ReportRecord report{"a", "path", {}, {}, {}, {}, {}};
  report.result.ok = report.result.looked = true;
  report.autopilot = "px4:1.15";
  report.assumed = {"MPC_XY_VEL_MAX"};
  report.navigation = {0, 0};
  report.returns = ReturnReport{.action = "rtl", .autopilot = "px4:1.15", .height = 60};
  EXPECT_EQ(said(report),
            "clear on every leg; as flown by px4:1.15; 1 parameter not given and assumed; allowed "
            "for an error of its own place of 0 m across and 0 m up or down; rtl is clear from "
            "every instant as px4:1.15 flies it, if the battery lasts");
}

TEST_F(Verdict, DoesNotRoundAValueToItsLimit) {
  ReportRecord fast = refused(broken(Limit::speed), 8.00001);
  fast.limits[Limit::speed] = 8;
  EXPECT_TRUE(said(fast).starts_with("the speed is 8.00001 m/s, above its limit of 8 m/s"));
  fast.result.worst = 8.7654321;
  EXPECT_TRUE(said(fast).starts_with("the speed is 8.765 m/s, above")) << said(fast);
}

TEST_F(Verdict, NamesAPlaceOnlyWhereThatTellsWhereToLook) {
  EXPECT_EQ(said(refused(unmeasured(Limit::jerk))).find("near"), npos);
  EXPECT_EQ(said(refused(Reason::duration_bound)).find("near"), npos);
  EXPECT_EQ(said(refused(Reason::return_home, 0)).find("near"), npos);
  EXPECT_NE(said(refused(Reason::return_home, 2)).find("near"), npos);
}

TEST_F(Verdict, SaysThatTheExactCheckRefuses) {
  ReportRecord report{"a", "path", {}, {}, {}, {}, {}};
  report.result.ok = true;
  report.exact = ExactResult{};
  report.exact->reason = Reason::collision;
  EXPECT_EQ(verdict_word(report), "exact");
  EXPECT_NE(said(report).find("exact check refuses"), npos);
}

TEST(VerdictOfATrajectory, SaysWhyThereIsNone) {
  TrajectoryRecord record;
  for (const auto& [status, word] : kTrajectoryStatusWords) {
    record.status = status;
    EXPECT_FALSE(in_words(record).empty()) << word;
    EXPECT_EQ(in_words(record).find_first_of("{}\n_"), npos) << in_words(record);
  }
  record.status = TrajectoryStatus::no_path;
  record.message = "start (1, 2, 3) is inside\nobstacle 3";
  EXPECT_EQ(in_words(record), "there is no path to fly: start (1, 2, 3) is inside\\nobstacle 3");
}

}  // namespace
}  // namespace traj
