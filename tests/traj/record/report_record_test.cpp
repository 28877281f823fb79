#include "traj/record/report_record.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "support/reading.h"
#include "traj/check/check_record.h"
#include "traj/record/verdict.h"
#include "traj/scenes.h"

namespace traj {
namespace {

std::string refusal(const std::string& line) {
  return support::refusal_of([&] { parse_report_record(line, "r.jsonl", 3); });
}

std::string found(const std::optional<geom::Fault>& fault) { return fault ? fault->found : ""; }

TEST(ReportSummary, ReadsWhatTheCheckWrote) {
  geom::BoxTable table;
  table.add({{1, 1, 1}, {2, 2, 2}}, 41);
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, table);
  ReportRecord record{"q1", "trajectory", {}, {.margin = 0.25}, {{Limit::speed, 8}}};
  record.result.looked = true;
  record.result.reason = Reason::collision;
  record.result.time = 1.5;
  record.result.place = {1, 2, 3};
  record.result.worst = 0.125;
  record.result.box = 0;
  record.result.duration = 4;
  record.result.clearance = Extreme{0, 1.25};
  record.result.largest[Limit::speed] = {7.5, 2};
  const ReportSummary back = parse_report_record(to_json_line(record, map), "r.jsonl", 1);
  EXPECT_EQ(back.id, "q1");
  EXPECT_EQ(back.checked, "trajectory");
  EXPECT_FALSE(back.ok);
  EXPECT_EQ(back.reason, "collision");
  EXPECT_EQ(back.time, 1.5);
  EXPECT_EQ(back.place, Vec3(1, 2, 3));
  EXPECT_EQ(back.worst, 0.125);
  EXPECT_EQ(back.box, 41u);
  EXPECT_EQ(back.duration, 4);
  ASSERT_EQ(back.extremes.size(), 2u);  // what was measured
  EXPECT_EQ(back.extremes[0].name, "clearance");
  EXPECT_EQ(back.extremes[0].time, 1.25);
  EXPECT_EQ(back.extremes[1].value, 7.5);
  EXPECT_EQ(back.provenance.margin, 0.25);
  EXPECT_EQ(back.limits[Limit::speed], 8);
}

TEST(ReportSummary, SaysWhatAYesRestsOn) {
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, {});
  ReportRecord record{"m", "path", {.ok = true}, {}, {{Limit::jerk, 8}}};
  record.result.looked = true;
  record.result.reason = Reason::none;
  record.exact = ExactResult{.ok = true};
  record.autopilot = "PX4";
  record.assumed = {"A", "B"};
  record.navigation = {{1, 2}};
  record.tracking = {{0.5, 0.25}};
  record.overridden = {"vmax", "vehicle"};
  record.returns = ReturnReport{.action = "rtl", .autopilot = "PX4", .height = 30, .duration = 4};
  record.returns->least_height = 25;
  record.tube = TubeReport{.claim = {.largest = 0.5, .tilt = 0.1}, .check = {.clear = true}};
  const std::string written = rests_on_in_words(record);
  EXPECT_NE(written.find("if the battery lasts"), std::string::npos);
  EXPECT_NE(written.find("not measured: jerk"), std::string::npos);
  EXPECT_NE(written.find("looser than its record says (--override or --spare): vmax, vehicle"),
            std::string::npos);
  const ReportSummary back = parse_report_record(to_json_line(record, map), "r.jsonl", 1);
  EXPECT_EQ(back.rests_on, written);
  EXPECT_TRUE(back.overridden);
}

TEST(ReportSummary, SaysThatASimulationAndALogAreNoProofs) {
  const auto rests = [](const char* line) {
    return parse_report_record(line, "r.jsonl", 1).rests_on;
  };
  EXPECT_EQ(rests(R"({"type":"flight","id":"q","ok":true})"),
            "one simulated flight, not a proof, and not held against a map");
  EXPECT_EQ(rests(R"({"type":"flight","id":"q","ok":true,"clear":true})"),
            "one simulated flight, not a proof");
  EXPECT_EQ(rests(R"({"type":"report","id":"q","ok":true,"verdict":"sampled",)"
                  R"("checked":"flight log","longest_step":0.25,"overridden":["map"]})"),
            "at the samples of a log and straight between them: what the vehicle did between, up "
            "to 0.25 s, was not measured; the log does not say its map, and was taken for this "
            "one (--override)");
  EXPECT_EQ(
      rests(R"({"type":"report","id":"q","ok":false,"reason":"speed","overridden":["vmax"]})"), "");
}

TEST(ReportSummary, IsOfATrajectoryOfItsDurationAndItsStart) {
  TrajectoryRecord flight;
  flight.id = "q";
  flight.trajectory.segments.resize(1);
  flight.trajectory.segments[0].duration = 4;
  const auto why = [&](const char* line) {
    return found(why_not_of(parse_report_record(line, "r.jsonl", 1), flight));
  };
  EXPECT_EQ(why(R"({"type":"report","id":"q","ok":true,"checked":"trajectory","duration":4})"), "");
  EXPECT_EQ(why(R"({"type":"report","id":"q","ok":true,"checked":"trajectory","duration":5})"),
            "one of another: it lasts 4 s, and the report is of one of 5 s");
  EXPECT_EQ(why(R"({"type":"report","id":"q","ok":true,"checked":"contingency","duration":5})"),
            "");
  const char* timed = R"({"type":"report","id":"q","ok":true,"checked":"trajectory","duration":4,)"
                      R"("timed_boxes":"by_time","start":60})";
  EXPECT_EQ(why(timed),
            "one of another: it starts at 0 s, and the report holds for a start at 60 s");
  flight.time.start = 60;
  EXPECT_EQ(why(timed), "");
}

TEST(ReportSummary, IsOfWhatHasItsNumbers) {
  geom::BoxTable table;
  table.add({{1, 1, 1}, {2, 2, 2}}, 41);
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, table);
  const geom::CollisionScene scene(map, {.half = {0.1, 0.1, 0.1}}, 0);
  const auto back = [&](const auto& record) {
    return parse_report_record(to_json_line(check_record(scene, record, {}, "t", 1), map), "r", 1);
  };
  TrajectoryRecord flight{.id = "q", .status = TrajectoryStatus::solved};
  flight.trajectory.segments.resize(1);
  flight.trajectory.segments[0].duration = 4;
  flight.trajectory.segments[0].point.fill({5, 5, 5});
  const ReportSummary report = back(flight);
  EXPECT_TRUE(report.ok);
  EXPECT_EQ(found(why_not_of(report, flight)), "");
  flight.trajectory.segments[0].point[3] = {1.5, 1.5, 1.5};  // through the box, as long
  EXPECT_EQ(found(why_not_of(report, flight)),
            "one of another: its control points, durations or yaws are others");

  geom::PathRecord path{.id = "q", .status = geom::PathStatus::found, .points = {{5, 5, 5}}};
  const ReportSummary of_path = back(path);
  EXPECT_EQ(found(why_not_of(of_path, path)), "");
  EXPECT_EQ(found(why_not_of(of_path, flight)), "");  // of another kind
  path.points.push_back({1.5, 1.5, 1.5});
  EXPECT_EQ(found(why_not_of(of_path, path)), "one of another: its points are others");
}

TEST(ReportSummary, SaysNothingOfWhatIsNotFinite) {
  geom::BoxTable table;
  table.add({{1, 1, 1}, {2, 2, 2}}, 41);
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, table);
  ReportRecord record{"q1", "trajectory", {}, {}, {}};
  record.result.looked = true;
  record.result.reason = broken(Limit::body_rate);
  record.result.worst = std::numeric_limits<double>::infinity();
  record.result.duration = 4;
  record.result.largest[Limit::speed] = {7.5, 2};
  record.result.largest[Limit::body_rate] = {std::numeric_limits<double>::quiet_NaN(), 1};
  const ReportSummary back = parse_report_record(to_json_line(record, map), "r.jsonl", 1);
  EXPECT_FALSE(back.worst);
  for (const auto& extreme : back.extremes) EXPECT_NE(extreme.name, std::string("body_rate"));
}

TEST(ReportSummary, ReadsWhatAFlightWas) {
  const auto report = parse_report_record(
      R"({"type":"flight","id":"q","ok":true,"rms":0.25,"max":1,"max_time":3})", "f.jsonl", 1);
  EXPECT_EQ(report.checked, "flight");
  ASSERT_EQ(report.extremes.size(), 2u);
  EXPECT_EQ(report.extremes[0].time, std::nullopt);
  EXPECT_EQ(report.extremes[1].time, 3);
}

TEST(ReportSummary, RefusesWhatIsNoReport) {
  EXPECT_EQ(refusal(R"({"type":"path","id":"a"})"),
            "r.jsonl:3: expected a record of type \"report\", found type \"path\"");
  EXPECT_EQ(refusal(R"({"type":"report","id":"a"})"),
            "r.jsonl:3: ok must be true or false, found none");
  EXPECT_EQ(refusal(R"({"type":"report","id":"a","ok":false})"),
            "r.jsonl:3: expected the key \"reason\", found none");
  EXPECT_EQ(refusal(R"({"type":"report","id":"a","ok":true,"box":-1})"),
            "r.jsonl:3: box must be a whole number >= 0, found -1");
  EXPECT_EQ(refusal(R"({"type":"report","id":"a","ok":true,"exact":1})"),
            "r.jsonl:3: exact must be an object, found 1");
  EXPECT_NE(refusal(R"({"type":"report","id":"a","ok":true,"speed":"fast"})"), "");
}

}  // namespace
}  // namespace traj
