#include "geom/text/words.h"

#include <gtest/gtest.h>

#include <set>

#include "geom/record/path_status.h"
#include "plan/planner/plan.h"
#include "traj/proof/reason.h"
#include "traj/record/trajectory_status.h"
#include "traj/solve/rung.h"

namespace geom {
namespace {

// Each value, from the first to the last of the enumeration, has one word, and each word one value.
template <class Enum, std::size_t N>
void expect_one_to_one(const Words<Enum, N>& words) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_EQ(static_cast<std::size_t>(words[i].value), i);
    EXPECT_EQ(word_of(words, words[i].value), words[i].word);
    EXPECT_EQ(value_of(words, words[i].word), words[i].value);
    EXPECT_TRUE(seen.insert(words[i].word).second) << words[i].word;
  }
  EXPECT_EQ(value_of(words, "no such word"), std::nullopt);
}

template <class Either, std::size_t N>
void expect_one_word_each(const Words<Either, N>& words) {
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_EQ(word_of(words, words[i].value), words[i].word);
    EXPECT_TRUE(value_of(words, words[i].word) == words[i].value) << words[i].word;
  }
  EXPECT_FALSE(value_of(words, "no such word"));
}

TEST(Words, GoBothWays) {
  expect_one_to_one(kPathStatusWords);
  expect_one_to_one(plan::kQualityWords);
  expect_one_to_one(plan::kSamplingWords);
  expect_one_to_one(traj::kTrajectoryStatusWords);
  expect_one_to_one(traj::kRungWords);
  expect_one_to_one(traj::kReasonWords);
}

TEST(Words, OfTwoEnumerationsAreOneTable) {
  static_assert(plan::kMethodWords.size() == 2 + plan::kSamplingWords.size());
  expect_one_word_each(plan::kMethodWords);
  expect_one_word_each(plan::kRouteWords);
  EXPECT_EQ(listed(plan::kMethodWords), "auto astar " + listed(plan::kSamplingWords));
}

TEST(Words, OfAValueThatTheTableForgotIsAnError) {
  EXPECT_THROW(word_of(kPathStatusWords, static_cast<PathStatus>(99)), std::logic_error);
}

TEST(Words, AreListedForMessages) {
  EXPECT_EQ(listed(traj::kRungWords), "closed banded ipopt stop_and_go");
  EXPECT_EQ(
      listed(plan::kRouteWords),
      "straight chain roadmap corridor lattice cells rrt rrt-connect rrt-star informed-rrt-star");
}

}  // namespace
}  // namespace geom
