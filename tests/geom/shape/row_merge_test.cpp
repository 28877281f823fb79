#include "shape/row_merge.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/random_city.h"

namespace geom {
namespace {

using Rectangle = CellRectangle<char>;

// Rows of letters from row `first` on; a dot is no cell.
std::vector<Rectangle> merged(const std::vector<std::string>& rows, long first = 0) {
  std::vector<Rectangle> out;
  const auto emit = [&](const Rectangle& r) { out.push_back(r); };
  RowMerge<char, decltype(emit)> merge(emit);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      if (rows[y][x] != '.')
        merge.add(first + static_cast<long>(y), static_cast<long>(x), rows[y][x]);
    }
  }
  merge.finish();
  return out;
}

void expect_one(const std::vector<Rectangle>& found, const Rectangle& r) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first_column, r.first_column);
  EXPECT_EQ(found[0].last_column, r.last_column);
  EXPECT_EQ(found[0].first_row, r.first_row);
  EXPECT_EQ(found[0].last_row, r.last_row);
  EXPECT_EQ(found[0].value, r.value);
}

TEST(RowMerge, MakesOneRectangleOfABlock) {
  expect_one(merged({".aa", ".aa", ".aa"}), {1, 3, 0, 3, 'a'});
  expect_one(merged({"a"}, -7), {0, 1, -7, -6, 'a'});
  EXPECT_TRUE(merged({}).empty());
}

TEST(RowMerge, ARunGrowsOnlyWhileTheNextRowRepeatsItExactly) {
  EXPECT_EQ(merged({"aa", "aaa"}).size(), 2u) << "wider";
  EXPECT_EQ(merged({"aa", "ab"}).size(), 3u) << "another value";
  EXPECT_EQ(merged({"aa", "..", "aa"}).size(), 2u) << "a row between";
  EXPECT_EQ(merged({"aa.bb", "aa.bb"}).size(), 2u);
  EXPECT_EQ(merged({"a.a"}).size(), 2u) << "a column between";
}

TEST(RowMerge, TakesRunsAndJoinsWhatTheCallerCallsOne) {
  std::vector<CellRectangle<int>> out;
  const auto emit = [&](const CellRectangle<int>& r) { out.push_back(r); };
  const auto join = [](int& into, int other) {  // to the larger, where they are near
    if (std::abs(into - other) > 2) return false;
    into = std::max(into, other);
    return true;
  };
  RowMerge<int, decltype(emit), decltype(join)> merge(emit, join);
  merge.add(0, 0, 4, 10);
  merge.add(0, 4, 6, 12);
  merge.add(0, 6, 7, 15);
  merge.add(1, 0, 6, 11);
  merge.add(1, 6, 7, 18);
  merge.finish();
  ASSERT_EQ(out.size(), 3u);
  EXPECT_EQ(out[0].value, 15);
  EXPECT_EQ(out[0].last_row, 1);
  EXPECT_EQ(out[1].value, 12);
  EXPECT_EQ(out[1].first_column, 0);
  EXPECT_EQ(out[1].last_column, 6);
  EXPECT_EQ(out[1].last_row, 2);
  EXPECT_EQ(out[2].value, 18);
  EXPECT_EQ(out[2].first_row, 1);
}

// Each cell lies in one rectangle of its value, and there are as many as runs that repeat none of
// the row before.
TEST(RowMerge, CoversEachCellOnceInAsFewRectanglesAsItSays) {
  support::Random random(3);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::string> rows(6, std::string(8, '.'));
    for (std::string& row : rows) {
      for (char& c : row) c = "..aab"[random.below(5)];
      if (&row != &rows[0] && random.below(2)) row = (&row)[-1];
    }
    std::vector<std::string> left = rows;
    const auto found = merged(rows);
    for (const Rectangle& r : found) {
      for (long y = r.first_row; y < r.last_row; ++y) {
        for (long x = r.first_column; x < r.last_column; ++x) {
          char& c = left[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
          ASSERT_EQ(c, r.value) << "seed 3, round " << round;
          c = '.';
        }
      }
    }
    std::size_t expected = 0;
    std::set<std::string> before;
    for (std::size_t y = 0; y < rows.size(); ++y) {
      ASSERT_EQ(left[y], "........") << "seed 3, round " << round;
      std::set<std::string> runs;  // as text: where they begin, and what they are
      for (std::size_t x = 0; x < 8;) {
        const std::size_t end = std::min<std::size_t>(8, rows[y].find_first_not_of(rows[y][x], x));
        if (rows[y][x] != '.') runs.insert(std::to_string(x) + rows[y].substr(x, end - x));
        x = end;
      }
      for (const std::string& run : runs) expected += before.count(run) == 0;
      before = runs;
    }
    ASSERT_EQ(found.size(), expected) << "seed 3, round " << round;
  }
}

}  // namespace
}  // namespace geom
