#include "traj/record/sampled_report.h"

#include <gtest/gtest.h>

#include "geom/text/json_fields.h"
#include "support/reading.h"
#include "traj/record/report_record.h"
#include "traj/record/verdict.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::says;

const geom::CollisionScene& scene() {
  static const auto out = testing::scene_of({{Vec3(10, -5, 0), Vec3(11, 5, 20)}});
  return out;
}

SampledReport report(const std::vector<Vec3>& points, const std::vector<double>& times) {
  return {"f", check_sampled(scene(), points, times), points.size(), false, {}, {}, {}};
}

TEST(SampledReport, SaysOkOfNothingWithoutARule) {
  const auto all = {report({{0, 0, 5}, {1, 0, 5}}, {0, 1}), report({{0, 0, 5}, {20, 0, 5}}, {0, 1}),
                    report({{0, 0, 5}, {1, 0, 5}}, {0, 9})};
  for (const SampledReport& one : all) {
    const std::string line = to_json_line(one, scene().map());
    EXPECT_TRUE(says(line, "\"ok\":false"));
    EXPECT_FALSE(says(line, "\"ok\":true"));
    EXPECT_FALSE(parse_report_record(line, "report", 1).ok);
  }
}

std::string said(SampledReport one, const SampledRule& rule) {
  one.rule = rule;
  const std::string line = to_json_line(one, scene().map());
  const ReportSummary read = parse_report_record(line, "report", 1);
  EXPECT_EQ(read.ok, read.reason.empty()) << line;
  EXPECT_EQ(read.reason, reason_of(one, scene().map())) << line;
  return read.reason;
}

// Comes as near as 2 m, and stays in the air.
const std::vector<Vec3> kNear = {{0, 0, 5}, {8, 0, 5}};

TEST(SampledReport, RefusesALogThatDoesNotSayItsMap) {
  SampledReport one = report(kNear, {0, 1});
  one.map_said = false;
  EXPECT_EQ(said(one, {}), "sampled") << "which is no yes in any case";
  EXPECT_EQ(said(one, {.sampled = true}), "no_map");
  EXPECT_EQ(said(one, {.clearance = 1}), "no_map");
  EXPECT_EQ(said(one, {.clearance = 1, .any_map = true}), "");
  EXPECT_TRUE(says(in_words(one, scene().map()), "--sampled"));
  one.rule = {.sampled = true};
  EXPECT_TRUE(says(in_words(one, scene().map()), "--override"));
  one.rule.any_map = true;
  EXPECT_TRUE(says(to_json_line(one, scene().map()), "\"overridden\":[\"map\"]"));
  EXPECT_TRUE(says(in_words(one, scene().map()), "; the log does not say its map, and was taken"));
  EXPECT_FALSE(says(to_json_line(report(kNear, {0, 1}), scene().map()), "overridden"));
}

TEST(SampledReport, AcceptsByItsRuleWhatTouchesNothing) {
  const SampledReport one = report(kNear, {0, 1});
  EXPECT_EQ(said(one, {}), "sampled");
  EXPECT_EQ(said(one, {.sampled = true}), "");
  EXPECT_EQ(said(one, {.clearance = 1.999}), "");
  EXPECT_EQ(said(one, {.clearance = 2.001}), "clearance");
  SampledReport asked = one;
  asked.rule = {.clearance = 1.5};
  const std::string line = to_json_line(asked, scene().map());
  EXPECT_TRUE(says(line,
                   "\"ok\":true,\"verdict\":\"clearance\",\"checked\":\"flight log\","
                   "\"required_clearance\":1.5,"));
}

// Whatever is asked: what was touched was touched, and what is not known is not accepted.
TEST(SampledReport, NoRuleAcceptsATouchAGapOrAnEndThatIsNotKnown) {
  const std::vector<SampledRule> rules = {{}, {.sampled = true}, {.clearance = 0}};
  SampledReport cut = report(kNear, {0, 1});
  cut.cut = true;
  for (const SampledRule& rule : rules) {
    EXPECT_EQ(said(report({{0, 0, 5}, {20, 0, 5}}, {0, 1}), rule), "collision");
    EXPECT_EQ(said(report({{0, 0, 5}, {0, 0, 5e3}}, {0, 1}), rule), "bounds");
    EXPECT_EQ(said(report(kNear, {0, 9}), rule), "gap");
    EXPECT_EQ(said(cut, rule), rule.sampled || rule.clearance ? "cut" : "sampled");
  }
}

TEST(SampledReport, AsksForMeasuredClearanceOnlyWhereThereAreObstacles) {
  const std::vector<Vec3> standing = {{0, 0, -0.1}, {0, 0, -0.1}};
  EXPECT_EQ(said(report(standing, {0, 1}), {.clearance = 1}), "clearance_not_measured");
  EXPECT_EQ(said(report(standing, {0, 1}), {.sampled = true}), "");
}

TEST(SampledReport, SaysHowCloseItCame) {
  const std::string line = to_json_line(report({{0, 0, 5}, {8, 0, 5}}, {0, 1}), scene().map());
  EXPECT_TRUE(says(line,
                   "\"reason\":\"sampled\",\"verdict\":\"sampled\",\"checked\":\"flight log\","
                   "\"clearance\":"));
  EXPECT_TRUE(says(line,
                   ",\"clearance_time\":1,\"nearest\":[8,0,5],\"duration\":1,\"samples\":2,"
                   "\"longest_step\":1"));
  const ReportSummary read = parse_report_record(line, "report", 1);
  EXPECT_EQ(read.reason, "sampled");
  EXPECT_NEAR(read.extremes.at(0).value, 2, 1e-8);
}

TEST(SampledReport, SaysWhereItTouched) {
  const std::string line = to_json_line(report({{0, 0, 5}, {20, 0, 5}}, {0, 1}), scene().map());
  EXPECT_FALSE(says(line, "verdict"));
  const ReportSummary read = parse_report_record(line, "report", 1);
  EXPECT_EQ(read.reason, "collision");
  EXPECT_EQ(read.box, scene().map().ids()[0]);
  EXPECT_TRUE(read.time && read.place);
}

TEST(SampledReport, SaysHowMuchStayedInTheTube) {
  SampledReport one = report({{0, 0, 5}, {1, 0, 5}}, {0, 1});
  one.cut = true;
  one.plan = FlownTube{{0.25, 1}, 1, 0.5};
  EXPECT_TRUE(says(to_json_line(one, scene().map()),
                   "\"cut\":true,\"plan\":{\"furthest\":0.25,\"furthest_time\":1}"));
  one.tube = TubeKind::statistics;
  EXPECT_TRUE(says(to_json_line(one, scene().map()),
                   "\"furthest_time\":1,\"tube\":\"statistics\",\"inside_tube\":1,\"share\":0.5,"
                   "\"left_tube\":0.5}"));
  EXPECT_TRUE(says(rests_on_in_words(one),
                   "not surely within its tube (statistics) at 1 of them, first at 0.5 s"));
  one.plan->inside = 2;
  EXPECT_EQ(rests_on_in_words(one), "");
}

}  // namespace
}  // namespace traj
