#include "geom/text/spoken_list.h"

#include <gtest/gtest.h>

#include <vector>

namespace geom {
namespace {

TEST(SpokenList, HasCommasAndALastWord) {
  const std::vector<std::string_view> words = {"a", "b", "c"};
  const std::span<const std::string_view> all(words);
  EXPECT_EQ(spoken_list(all, "or"), "a, b or c");
  EXPECT_EQ(spoken_list(all.first(2), "and"), "a and b");
  EXPECT_EQ(spoken_list(all.first(1), "and"), "a");
  EXPECT_EQ(spoken_list({}, "and"), "");
}

}  // namespace
}  // namespace geom
