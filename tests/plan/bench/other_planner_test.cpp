#include "plan/bench/other_planner.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "support/walled_scene.h"

namespace plan::bench {
namespace {

constexpr const char* kAround =
    R"({"type":"path","id":"q1","status":"found","points":[[10,50,10],[47,10,10],[53,10,10],[90,50,10]]})";

Run judged(std::vector<std::string> lines) {
  AnswerLines answers{std::move(lines), 3, 1000};
  const geom::PlanQuery other{"q2", {10, 10, 10}, {20, 10, 10}, {}, 0};
  return judge_lines("theirs", answers, support::walled_scene(),
                     std::vector{support::kAcross, other});
}

TEST(QueryLines, HaveTheIdAndBothEnds) {
  EXPECT_EQ(query_lines(std::vector{geom::PlanQuery{"a", {1, 2, 3}, {4, 5, 6}, {}, 0}}),
            R"({"id":"a","from":[1,2,3],"to":[4,5,6]})"
            "\n");
}

TEST(JudgeLines, MatchesAnswersByIdAndGivesEachTheMeanTime) {
  const plan::bench::Run run = judged({kAround});
  ASSERT_EQ(run.trials.size(), 2u);
  EXPECT_EQ(run.trials[0].verdict, Verdict::found);
  EXPECT_EQ(run.trials[0].seconds, 1.5);
  EXPECT_EQ(run.trials[1].verdict, Verdict::failed);
  EXPECT_EQ(run.method, "theirs");
  EXPECT_TRUE(run.one_process);
  EXPECT_EQ(run.missing, 1u);
  EXPECT_EQ(run.extra, 0u);
}

TEST(JudgeLines, CountsAnswersToNoQueryAndSecondOnes) {
  const std::string stranger = R"({"type":"path","id":"x","status":"unreachable"})";
  EXPECT_EQ(judged({kAround, kAround, stranger}).extra, 2u);
}

TEST(JudgeLines, BelievesNoPath) {
  const std::string through =
      R"({"type":"path","id":"q1","status":"found","points":[[10,50,10],[90,50,10]]})";
  EXPECT_EQ(judged({through}).trials[0].verdict, Verdict::invalid);
}

TEST(JudgeLines, RefusesWhatIsNoPathRecordOrForAnotherMap) {
  EXPECT_EQ(support::refusal_of([] { judged({"{}"}); }).find("planner-cmd:1: "), 0u);
  std::string record = kAround;
  record.insert(1, R"("margin":2,)");
  EXPECT_EQ(support::refusal_of([&] { judged({kAround, record}); }).find("planner-cmd:2: "), 0u);
}

}  // namespace
}  // namespace plan::bench
