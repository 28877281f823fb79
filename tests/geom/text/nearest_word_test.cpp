#include "geom/text/nearest_word.h"

#include <gtest/gtest.h>

#include <vector>

namespace geom {
namespace {

const std::vector<std::string> kVerbs = {"plan", "replan", "import", "import-trajectory", "check"};

TEST(EditDistance, CountsLettersAddedLeftOutChangedAndSwapped) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("plan", "plan"), 0u);
  EXPECT_EQ(edit_distance("pln", "plan"), 1u);
  EXPECT_EQ(edit_distance("plaan", "plan"), 1u);
  EXPECT_EQ(edit_distance("plen", "plan"), 1u);
  EXPECT_EQ(edit_distance("plna", "plan"), 1u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // a letter is touched once
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestWord, IsAtMostTwoEditsAway) {
  EXPECT_EQ(nearest_word("plna", kVerbs), "plan");
  EXPECT_EQ(nearest_word("chekc", kVerbs), "check");
  EXPECT_EQ(nearest_word("ipmrot", kVerbs), "import");
  EXPECT_EQ(nearest_word("render", kVerbs), std::nullopt);
}

TEST(NearestWord, IsTheFirstOfEquals) {
  EXPECT_EQ(nearest_word("bat", std::vector<std::string>{"cat", "hat"}), "cat");
}

TEST(NearestWord, ChangesFewerLettersThanAWordHas) {
  const std::vector<std::string> known = {"abc", "wpl", "bt"};
  EXPECT_EQ(nearest_word("xy", known), std::nullopt);
  EXPECT_EQ(nearest_word("b", known), std::nullopt);
  EXPECT_EQ(nearest_word("wp", known), "wpl");
  EXPECT_EQ(nearest_word("", known), std::nullopt);
}

TEST(NearestWord, DoesNotCountCaseBlanksAndHyphens) {
  EXPECT_EQ(nearest_word("RRT", std::vector<std::string>{"astar", "rrt", "rrt-star"}), "rrt");
  EXPECT_EQ(nearest_word("Stop And Go", std::vector<std::string>{"closed", "stop-and-go"}),
            "stop-and-go");
  EXPECT_EQ(nearest_word("--vmx", std::vector<std::string>{"--amax", "--vmax"}), "--vmax");
}

TEST(NearestWord, IsFirstOneThatHasItBetweenHyphens) {
  const std::vector<std::string> known = {"wpl", "qgc-plan", "dji-wpml"};
  EXPECT_EQ(nearest_word("wpml", known), "dji-wpml");
  EXPECT_EQ(nearest_word("plan", known), "qgc-plan");
  EXPECT_EQ(nearest_word("wp", known), "wpl");
  const std::vector<std::string> methods = {"informed-rrt-star", "rrt"};
  EXPECT_EQ(nearest_word("RRT", methods), "rrt") << "the whole word before a part";
}

TEST(NearestWord, IsElseTheShortestThatItBegins) {
  EXPECT_EQ(nearest_word("imp", kVerbs), "import");
  EXPECT_EQ(nearest_word("--form", std::vector<std::string>{"--file-format", "--format"}),
            "--format");
}

TEST(DidYouMean, AsksOrSaysNothing) {
  EXPECT_EQ(did_you_mean("plna", kVerbs), "; did you mean plan?");
  EXPECT_EQ(did_you_mean("render", kVerbs), "");
}

}  // namespace
}  // namespace geom
