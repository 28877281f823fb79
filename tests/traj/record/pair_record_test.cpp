#include "traj/record/pair_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/text/parse_json.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::straight;

struct Two {
  Trajectory a = straight({0, 0, 30}, {80, 0, 30});
  Trajectory b = straight({40, -40, 30}, {40, 40, 30});
  std::vector<TimedFlight> flights{{&a, 0, {1, 1, 1}}, {&b, 0, {2, 2, 2}}};
  TogetherTask task{{"a \"x\"", "b"}, {}, "2026-05-04T06:30:00Z", "sha256:0"};
};

nlohmann::json parsed(const std::string& line) {
  EXPECT_EQ(line.back(), '\n');
  return geom::parse_json(line, "line");
}

TEST(PairRecord, NamesBothFlightsAndWhen) {
  Two two;
  const auto result = check_together(two.flights, two.task.rule);
  ASSERT_EQ(result.refused.size(), 1u);
  const auto line = parsed(to_json_line(result.refused[0], two.task));
  EXPECT_EQ(line["ids"], nlohmann::json({"a \"x\"", "b"}));
  EXPECT_EQ(line["ok"], false);
  EXPECT_EQ(line["reason"], "separation");
  EXPECT_EQ(line["zone"]["reach"], nlohmann::json({3.0, 3.0, 3.0}));
  EXPECT_EQ(line["when"].size(), 1u);
  EXPECT_NE(in_words(result.refused[0], two.task).find("a \"x\" and b"), std::string::npos);
}

TEST(PairRecord, HasNoTimeWhereAConflictHasNoEnd) {
  Two two;
  two.b = straight({80, 0, 30}, {80, 0, 30});
  const auto result = check_together(two.flights, two.task.rule);
  const auto line = parsed(to_json_line(result.refused.at(0), two.task));
  EXPECT_TRUE(line["when"].back()[1].is_null());
}

TEST(PairRecord, OfAllIsNotOkWhereAFlightIsLeftOut) {
  Two two;
  two.task.rule.spacing.zone = cylinder(1, 1);
  two.flights[1].start = 100;
  two.task.rule.parked = Parked::gone;
  const auto result = check_together(two.flights, two.task.rule);
  EXPECT_EQ(parsed(to_json_line(result, two.task, 0))["ok"], true);
  EXPECT_EQ(parsed(to_json_line(result, two.task, 1))["ok"], false);
  EXPECT_EQ(parsed(to_json_line(result, two.task, 1))["left_out"], 1);
}

TEST(PairRecord, CertifiesWhatIsClaimedAndWhy) {
  Two two;
  two.flights[1].start = 2;
  two.task.rule.exact = true;
  two.task.rule.parked = Parked::gone;
  const auto result = check_together(two.flights, two.task.rule);
  ASSERT_TRUE(result.ok());
  const auto claim = parsed(certificate_line(two.task, two.flights));
  EXPECT_EQ(claim["separation"], "vehicles");
  EXPECT_EQ(claim["rooms"][1], nlohmann::json({2.0, 2.0, 2.0}));
  ASSERT_EQ(result.proved.size(), 1u);
  const auto why = parsed(certificate_line(result.proved[0], two.task));
  EXPECT_EQ(why["stretches"].size(), 1u);
  EXPECT_EQ(why["stretches"][0][0]["pieces"].size(), why["stretches"][0][0]["sides"].size());
}

}  // namespace
}  // namespace traj
