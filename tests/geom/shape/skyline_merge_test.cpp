#include "shape/skyline_merge.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/random_city.h"

namespace geom {
namespace {

using Rectangle = CellRectangle<double>;

// Rows of digits, the heights; a dot is no cell.
std::vector<Rectangle> merged(const std::vector<std::string>& rows, long most_columns = 100,
                              long most_rows = 100) {
  std::vector<Rectangle> out;
  const auto emit = [&](const Rectangle& r) { out.push_back(r); };
  SkylineMerge<decltype(emit)> merge(emit, most_columns, most_rows);
  for (const std::string& row : rows) {
    std::vector<double> heights;
    for (const char c : row) {
      heights.push_back(c == '.' ? std::numeric_limits<double>::quiet_NaN() : c - '0');
    }
    merge.add_row(heights);
  }
  merge.finish();
  return out;
}

char& at(std::vector<std::string>& rows, long row, long column) {
  return rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
}

// Each cell lies in a rectangle of its height, none in a higher one, and what is no cell in none.
void expect_same_columns(const std::vector<std::string>& rows,
                         const std::vector<Rectangle>& rectangles, const std::string& what) {
  std::vector<std::string> highest(rows.size());
  for (std::size_t y = 0; y < rows.size(); ++y) highest[y].assign(rows[y].size(), '.');
  for (const Rectangle& r : rectangles) {
    for (long y = r.first_row; y < r.last_row; ++y) {
      for (long x = r.first_column; x < r.last_column; ++x) {
        at(highest, y, x) = std::max(at(highest, y, x), static_cast<char>('0' + r.value));
      }
    }
  }
  EXPECT_EQ(highest, rows) << what;
}

TEST(SkylineMerge, PassesBelowWhatIsHigher) {
  const std::vector<std::string> rows = {"1121", "1111", "3111"};
  const auto found = merged(rows);
  ASSERT_EQ(found.size(), 3u);  // the ground, and two trees
  expect_same_columns(rows, found, "trees");
  EXPECT_EQ(merged({"12321"}).size(), 3u);
  EXPECT_EQ(merged({"121"}).size(), 2u);
}

TEST(SkylineMerge, EndsAtWhatIsLowerAndAtNoCell) {
  EXPECT_EQ(merged({"2122"}).size(), 3u);
  EXPECT_EQ(merged({"22.22"}).size(), 2u);
  EXPECT_EQ(merged({"22", "..", "22"}).size(), 2u);
  EXPECT_EQ(merged({"22", "21"}).size(), 3u);
  EXPECT_TRUE(merged({"...", "..."}).empty());
  EXPECT_TRUE(merged({}).empty());
}

TEST(SkylineMerge, KeepsToItsMostButForLongRunsOfOneHeight) {
  const std::vector<std::string> rows(4, "1111");
  EXPECT_EQ(merged(rows, 2, 2).size(), 4u);
  EXPECT_EQ(merged(rows, 4, 1).size(), 4u);
  const std::string run(2 * SkylineMerge<void (*)(const Rectangle&)>::kWide, '1');
  EXPECT_EQ(merged({run, run, run}, 2, 2).size(), 1u);
  EXPECT_EQ(merged({run, run + "1"}, 2, 2).size(), 2u);
}

TEST(SkylineMerge, StandsOnTheSameColumns) {
  support::Random random(5);
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random.below(static_cast<int>(n)));
  };
  std::size_t plain = 0;
  std::size_t found = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t width = 1 + below(40);
    std::vector<std::string> rows(1 + below(7), std::string(width, '.'));
    const std::string kinds = below(2) ? "..1112233" : "11111111112345";
    for (std::string& row : rows) {
      for (char& c : row) c = kinds[below(kinds.size())];
      if (&row != &rows[0] && below(3) == 0) row = (&row)[-1];
      if (below(3) == 0) row.replace(0, width / 2, std::string(width / 2, '1'));
    }
    const long columns = 1 + static_cast<long>(below(below(2) ? 3 : 50));
    const long most_rows = 1 + static_cast<long>(below(8));
    const auto rectangles = merged(rows, columns, most_rows);
    expect_same_columns(rows, rectangles, "seed 5, round " + std::to_string(round));
    for (const Rectangle& r : rectangles) {
      const long across = r.last_column - r.first_column;
      EXPECT_TRUE((across <= columns && r.last_row - r.first_row <= most_rows) ||
                  across >= 8 * columns)
          << "seed 5, round " << round;
    }
    const auto count = [&](const Rectangle&) { ++plain; };
    RowMerge<double, decltype(count)> merge(count);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        if (rows[y][x] != '.') merge.add(static_cast<long>(y), static_cast<long>(x), rows[y][x]);
      }
    }
    merge.finish();
    found += merged(rows).size();
  }
  EXPECT_LT(found, plain);
}

}  // namespace
}  // namespace geom
