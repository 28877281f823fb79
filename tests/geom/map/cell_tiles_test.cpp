#include "map/cell_tiles.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>

#include "support/random_city.h"

namespace geom {
namespace {

constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

TEST(CellTiles, AreEmptyBeforeTheFirstTouch) {
  const CellTiles<int> tiles;
  EXPECT_EQ(tiles.find(0, 0), nullptr);
  EXPECT_TRUE(tiles.sorted().empty());
  EXPECT_EQ(tiles.size(), 0u);
}

TEST(CellTiles, CountTheTilesThatWereMade) {
  CellTiles<int> tiles;
  tiles.at(0, 0) = 1;
  tiles.at(15, 15) = 1;
  EXPECT_EQ(tiles.size(), 1u);
  tiles.at(16, -1) = 1;
  EXPECT_EQ(tiles.size(), 2u);
}

TEST(CellTiles, BeginWithTheValueOfTheirType) {
  CellTiles<int> tiles;
  EXPECT_EQ(tiles.at(-1, 5), 0);
  ASSERT_NE(tiles.find(-16, 0), nullptr);  // of the same tile, never touched
  EXPECT_EQ(*tiles.find(-16, 0), 0);
  EXPECT_EQ(tiles.find(0, 5), nullptr);  // of the next one
  EXPECT_EQ(tiles.find(-17, 5), nullptr);
}

TEST(CellTiles, KeepWhatAMapKeeps) {
  support::Random random(1);
  CellTiles<int> tiles;
  std::map<std::pair<std::int32_t, std::int32_t>, int> known;
  for (const std::int32_t side : {20, 3000}) {
    for (int i = 0; i < 20000; ++i) {
      const std::int32_t x = random.below(2 * side) - side;
      const std::int32_t y = random.below(2 * side) - side;
      tiles.at(x, y) += i;
      known[{x, y}] += i;
    }
  }
  for (const auto& [cell, value] : known) {
    const int* found = tiles.find(cell.first, cell.second);
    ASSERT_NE(found, nullptr) << cell.first << ", " << cell.second;
    ASSERT_EQ(*found, value) << cell.first << ", " << cell.second;
  }
}

TEST(CellTiles, ReachToTheLastIndices) {
  CellTiles<int> tiles;
  int value = 0;
  for (const std::int32_t x : {kLeast, -1, 0, kMost}) {
    for (const std::int32_t y : {kLeast, -1, 0, kMost}) tiles.at(x, y) = ++value;
  }
  value = 0;
  for (const std::int32_t x : {kLeast, -1, 0, kMost}) {
    for (const std::int32_t y : {kLeast, -1, 0, kMost}) {
      ASSERT_NE(tiles.find(x, y), nullptr) << x << ", " << y;
      EXPECT_EQ(*tiles.find(x, y), ++value) << x << ", " << y;
    }
  }
}

TEST(CellTiles, AreSortedByYThenX) {
  CellTiles<int> tiles;
  for (const auto& [x, y] : {std::pair{40, 0}, {0, 40}, {-40, 0}, {0, -40}}) tiles.at(x, y) = x;
  const auto sorted = tiles.sorted();
  ASSERT_EQ(sorted.size(), 4u);
  EXPECT_EQ(sorted[0]->y, -3);
  EXPECT_EQ(sorted[1]->x, -3);
  EXPECT_EQ(sorted[2]->x, 2);
  EXPECT_EQ(sorted[3]->y, 2);
  constexpr int kSide = CellTiles<int>::kSide;
  EXPECT_EQ(sorted[2]->cells[40 - 2 * kSide], 40);
}

}  // namespace
}  // namespace geom
