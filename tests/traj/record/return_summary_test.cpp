#include "traj/record/return_summary.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/record/report_record.h"

namespace traj {
namespace {

std::string refusal(const std::string& json) {
  return support::refusal_of([&] { parse_return_summary(json, "r.jsonl", 3); });
}

// A return of that many seconds, with gaps.
std::string json(const std::string& gaps, const std::string& share = "0.5") {
  return R"({"action":"rtl","autopilot":"px4:1.17","height":60,"duration":10,"longest":90,"share":)" +
         share + R"(,"gaps":[)" + gaps + "]}";
}

std::string gap(const std::string& from, const std::string& until) {
  return R"({"from":)" + from + R"(,"until":)" + until +
         R"(,"phase":"way","reason":"collision","at":[1,2,3],"box":7})";
}

TEST(ReturnSummary, ReadsWhatTheCheckWrote) {
  geom::BoxTable table;
  table.add({{1, 1, 1}, {2, 2, 2}}, 41);
  const geom::BoxMap map({.bounds = {{0, 0, 0}, {9, 9, 9}}}, table);
  ReportRecord record{"q1", "trajectory", {}, {}, {}};
  record.result.looked = true;
  record.result.ok = true;
  record.result.duration = 120;
  ReturnReport returns{.action = "rtl", .autopilot = "px4:1.17", .home = {1, 2, 3}, .height = 60};
  returns.duration = 120;
  returns.longest = 250;
  returns.least_height = 74.5;
  returns.gaps.push_back({.from = 30, .until = 42, .autopilot = "px4:1.17", .phase = "way"});
  returns.gaps.back().place = {4, 5, 6};
  returns.gaps.back().box = 0;
  returns.gaps.push_back({.from = 50, .until = 56, .phase = "climb", .reason = Reason::fence});
  returns.gaps.back().part = FlightPart{4, Manoeuvre::leg};
  returns.gaps.back().fence = 2;
  returns.timeline = {{0, {1, 2, 3}}, {120, {4, 5, 6}}};
  record.returns = returns;

  const ReportSummary back = parse_report_record(to_json_line(record, map), "r.jsonl", 1);
  EXPECT_FALSE(back.ok);
  ASSERT_TRUE(back.returns);
  EXPECT_EQ(back.returns->action, "rtl");
  EXPECT_EQ(back.returns->autopilot, "px4:1.17");
  EXPECT_EQ(back.returns->home, geom::Vec3(1, 2, 3));
  EXPECT_EQ(back.returns->height, 60);
  EXPECT_EQ(back.returns->share, returns.share());
  EXPECT_EQ(back.returns->duration, 120);
  EXPECT_EQ(back.returns->longest, 250);
  EXPECT_EQ(back.returns->least_height, 74.5);
  ASSERT_EQ(back.returns->timeline.size(), 2u);
  EXPECT_EQ(back.returns->timeline[1].time, 120);
  EXPECT_EQ(back.returns->timeline[1].place, geom::Vec3(4, 5, 6));
  ASSERT_EQ(back.returns->gaps.size(), 2u);
  const ReturnGapSummary& first = back.returns->gaps[0];
  EXPECT_EQ(first.from, 30);
  EXPECT_EQ(first.until, 42);
  EXPECT_EQ(first.phase, "way");
  EXPECT_EQ(first.reason, "collision");
  EXPECT_EQ(first.place, geom::Vec3(4, 5, 6));
  EXPECT_EQ(first.box, 41u);
  EXPECT_FALSE(first.item);
  const ReturnGapSummary& second = back.returns->gaps[1];
  EXPECT_EQ(second.item, 4u);
  EXPECT_EQ(second.part, "leg");
  EXPECT_EQ(second.reason, "fence");
  EXPECT_EQ(second.fence, 2u);
  EXPECT_FALSE(second.box);
}

TEST(ReturnSummary, IsOkWithoutGaps) {
  EXPECT_TRUE(parse_return_summary(json("", "1"), "r", 1).ok());
  EXPECT_FALSE(parse_return_summary(json(gap("2", "7")), "r", 1).ok());
}

TEST(ReturnSummary, ReadsTheBestHeightWhereNoneIsWhole) {
  const auto plain = parse_return_summary(json(gap("2", "7")), "r", 1);
  EXPECT_FALSE(plain.least_height || plain.best_height || plain.best_share);
  const auto best = parse_return_summary(
      json(gap("2", "7"), R"(0.5,"best_height":55.5,"best_share":0.75)"), "r", 1);
  EXPECT_EQ(best.best_height, 55.5);
  EXPECT_EQ(best.best_share, 0.75);
}

TEST(ReturnSummary, RefusesGapsOutOfOrder) {
  EXPECT_EQ(refusal(json(gap("2", "3") + "," + gap("3", "7"))), "");  // they may touch
  EXPECT_EQ(
      refusal(json(gap("4", "7") + "," + gap("6", "8"))),
      "r.jsonl:3: gaps must be apart, ascending and within 0 to 10 s, found one from 6 to 8 s "
      "after 7 s");
  EXPECT_NE(refusal(json(gap("7", "4"))), "");
  EXPECT_NE(refusal(json(gap("-1", "4"))), "");
  EXPECT_NE(refusal(json(gap("6", "10.5"))), "");
}

TEST(ReturnSummary, RefusesAShareThatGapsDoNotLeave) {
  EXPECT_EQ(refusal(json(gap("2", "7"), "0.5")), "");
  EXPECT_EQ(refusal(json(gap("2", "7"), "0.4")), "");  // it may claim less
  EXPECT_EQ(refusal(json(gap("2", "7"), "0.75")),
            "r.jsonl:3: share must be at most 0.5, as the gaps leave it, found 0.75");
  EXPECT_NE(refusal(json("", "-0.5")), "");
  EXPECT_NE(refusal(json("", "1.5")), "");
}

TEST(ReturnSummary, RefusesWhatIsMissingOrNoNumber) {
  EXPECT_NE(refusal(R"({"action":"rtl","duration":10,"share":1})"), "");
  EXPECT_NE(refusal(R"({"duration":10,"share":1,"gaps":[]})"), "");
  EXPECT_NE(refusal(json(R"({"from":1,"until":"later","phase":"way","reason":"collision"})")), "");
  EXPECT_NE(refusal(json(R"({"from":1,"until":2,"reason":"collision"})")), "");
  EXPECT_NE(refusal(json("7")), "");
  EXPECT_NE(refusal("[]"), "");
}

TEST(ReturnSummary, AReportIsNotOkBesideGaps) {
  const std::string head = R"({"type":"report","id":"a","ok":true,"return":)";
  EXPECT_TRUE(parse_report_record(head + json("", "1") + "}", "r", 1).returns->ok());
  EXPECT_EQ(support::refusal_of(
                [&] { parse_report_record(head + json(gap("2", "7")) + "}", "r.jsonl", 3); }),
            "r.jsonl:3: ok is true beside times without a return");
}

TEST(ReturnSummary, RefusesATimelineThatDoesNotAscend) {
  const auto with = [](const std::string& first, const std::string& second) {
    std::string line = json("", "1");
    line.insert(line.size() - 1, R"(,"timeline":[{"time":)" + first + R"(,"at":[0,0,0]},{"time":)" +
                                     second + R"(,"at":[1,0,0]}])");
    return line;
  };
  EXPECT_EQ(refusal(with("0", "10")), "");
  for (const auto& line : {with("5", "4"), with("0", "10.1"), with("-1", "4"), with("0", "\"a\"")})
    EXPECT_NE(refusal(line), "") << line;
}

}  // namespace
}  // namespace traj
