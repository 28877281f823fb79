#include "traj/record/pair_summary.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/record/pair_record.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::straight;

TEST(PairSummary, IsWhatWasWritten) {
  const Trajectory a = straight({0, 0, 30}, {80, 0, 30});
  const Trajectory b = straight({40, -40, 31}, {40, 40, 31});
  const std::vector<TimedFlight> flights{{&a, 5, {1, 1, 1}}, {&b, 5, {2, 2, 2}}};
  const TogetherTask task{{"a", "b"}, {}, {}, "sha256:0", "12ab"};
  const TogetherResult result = check_together(flights, task.rule);
  ASSERT_EQ(result.refused.size(), 1u);
  const PairSummary pair = parse_pair_record(to_json_line(result.refused[0], task), "f", 1);
  EXPECT_EQ(pair.first, "a");
  EXPECT_EQ(pair.second, "b");
  EXPECT_EQ(pair.reason, "separation");
  EXPECT_EQ(pair.time, result.refused[0].result.time);
  EXPECT_EQ(pair.share, result.refused[0].result.share);
  EXPECT_NEAR(pair.up, 1, 1e-12);
  EXPECT_EQ(pair.zone, (Zone{false, {3, 3, 3}}));
  const TogetherSummary all = parse_together_record(to_json_line(result, task, 3), "f", 2);
  EXPECT_FALSE(all.ok);
  EXPECT_EQ(all.flights, 2u);
  EXPECT_EQ(all.pairs, 1u);
  EXPECT_EQ(all.refused, 1u);
  EXPECT_EQ(all.left_out, 3u);
  EXPECT_EQ(all.map, "sha256:0");
  EXPECT_EQ(all.flights_hash, "12ab");
  EXPECT_FALSE(all.separation);  // the vehicles' sizes say it
}

TEST(PairSummary, SaysWhatWasAsked) {
  TogetherTask task{{"a", "b"}, {}, {}, "sha256:0", "12ab"};
  task.rule.spacing.zone = cylinder(5, 3);
  const std::string line = to_json_line(TogetherResult{}, task, 0);
  EXPECT_EQ(parse_together_record(line, "f", 1).separation, cylinder(5, 3));
  EXPECT_FALSE(parse_together_record(line, "f", 1).overridden);
  task.overridden = true;
  EXPECT_TRUE(parse_together_record(to_json_line({}, task, 0), "f", 1).overridden);
}

void expect_refused(const std::string& json, const std::string& why) {
  const std::string said = support::refusal_of([&] {
    if (support::says(json, "together")) {
      parse_together_record(json, "f", 4);
    } else {
      parse_pair_record(json, "f", 4);
    }
  });
  EXPECT_TRUE(support::says(said, "f:4")) << json;
  EXPECT_TRUE(support::says(said, why)) << json;
}

TEST(PairSummary, RefusesWhatIsNone) {
  const std::string rest = R"("reason":"separation","time":1,"share":0.5,"across":1,"up":0})";
  expect_refused(R"({"type":"pair","ids":["a"],"ok":false,)" + rest, "ids");
  expect_refused(R"({"type":"pair","ids":["a","b"],"ok":false,"zone":{"reach":[1,2]},)" + rest,
                 "zone");
  expect_refused(R"({"type":"pair","ids":["a",1],"ok":false,)" + rest, "ids");
  expect_refused(R"({"type":"pair","ids":["a","b"],"ok":true,)" + rest, "ok");
  expect_refused(R"({"type":"pair","ids":["a","b"],"ok":0,)" + rest, "ok");
  expect_refused(R"({"type":"pair","ids":["a","b"],"ok":false,"reason":"separation"})", "time");
  expect_refused(R"({"type":"report","ids":["a","b"],"ok":false,)" + rest, "report");
}

TEST(TogetherSummary, IsNotOkBesideRefusals) {
  const auto of = [](const char* ok, const char* refused, const char* more) {
    return std::string(R"({"type":"together","ok":)") + ok +
           R"(,"flights_hash":"0","flights":3,"pairs":3,"refused":)" + refused + more + "}";
  };
  EXPECT_TRUE(parse_together_record(of("true", "0", ""), "f", 1).ok);
  expect_refused(of("true", "1", ""), "ok is true");
  expect_refused(of("true", "0", R"(,"left_out":1)"), "ok is true");
  expect_refused(of("true", "-1", ""), "refused");
  expect_refused(of("\"yes\"", "0", ""), "ok");
  expect_refused(R"({"type":"together","ok":true,"flights":3,"pairs":3,"refused":0})",
                 "flights_hash");
}

}  // namespace
}  // namespace traj
