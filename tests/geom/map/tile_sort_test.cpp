#include "map/tile_sort.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "map/tile_order.h"
#include "support/random_city.h"

namespace geom {
namespace {

// Boxes many of which are equal, with ids that repeat, some timed; far out, too.
BoxTable table_of(std::uint64_t seed, int count, double side) {
  support::Random random(seed);
  BoxTable table;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(random.stepped(-side, side, side / 20), random.stepped(-side, side, side / 20),
                   random.below(3) - 1.0);
    const Vec3 size(random.below(9) ? random.below(4) : side, random.below(4), random.below(3));
    table.add({low, low + size}, static_cast<std::uint64_t>(random.below(5)),
              static_cast<std::uint32_t>(random.below(2)));
    if (random.below(4) == 0) {
      table.set_time(table.boxes.size() - 1, {random.below(3) - 1.0, 5.0 + random.below(2)});
    }
  }
  return table;
}

std::vector<std::size_t> sorted_by_definition(const BoxTable& table, double size) {
  std::vector<std::size_t> order(table.boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Place place_a = place_of(table.boxes[a], size);
    const Place place_b = place_of(table.boxes[b], size);
    if (place_a != place_b) return place_a < place_b;
    if (!(table.boxes[a] == table.boxes[b])) return comes_before(table.boxes[a], table.boxes[b]);
    if (table.ids[a] != table.ids[b]) return table.ids[a] < table.ids[b];
    if (table.time(a) != table.time(b)) return table.time(a) < table.time(b);
    return a < b;
  });
  return order;
}

TEST(TileSort, IsByTileAndThenByBoxIdAndTimeForAnyNumberOfThreads) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const double side = seed % 3 == 0 ? 9e7 : 400;
    const double size = seed % 2 ? 100 : 1;
    const BoxTable table = table_of(seed, seed < 10 ? 700 : 70000, side);
    const std::vector<std::size_t> order = sorted_by_definition(table, size);
    std::vector<Aabb> by_coordinates = table.boxes;
    std::sort(by_coordinates.begin(), by_coordinates.end(), comes_before);
    for (const unsigned threads : {1u, 2u, 7u}) {
      std::vector<Aabb> taken;
      const SortedBoxes sorted =
          sorted_by_tile(table, size, {threads, {}}, [&](std::span<const Aabb> boxes) {
            taken.insert(taken.end(), boxes.begin(), boxes.end());
          });
      ASSERT_EQ(taken, by_coordinates) << seed << ", " << threads;
      ASSERT_EQ(sorted.boxes->boxes.all().size(), order.size());
      std::size_t timed = 0;
      for (std::size_t i = 0; i < order.size(); ++i) {
        ASSERT_EQ(sorted.boxes->boxes.all()[i], table.boxes[order[i]]) << seed << ", box " << i;
        ASSERT_EQ(sorted.boxes->ids.all()[i], table.ids[order[i]]) << seed << ", box " << i;
        ASSERT_EQ(sorted.boxes->label.all()[i], table.label[order[i]]) << seed << ", box " << i;
        if (table.time(order[i]).always()) continue;
        ASSERT_EQ(sorted.boxes->timed.at(timed), i);
        ASSERT_EQ(sorted.boxes->times.at(timed++), table.time(order[i]));
      }
      EXPECT_EQ(sorted.boxes->timed.size(), timed);
    }
  }
}

TEST(TileSort, GivesTheBoxesOfALongColumnByCoordinatesToo) {
  const BoxTable table = table_of(3, 300000, 400);
  std::vector<Aabb> expected = table.boxes;
  std::sort(expected.begin(), expected.end(), comes_before);
  std::vector<Aabb> taken;
  const auto take = [&](std::span<const Aabb> boxes) {
    taken.insert(taken.end(), boxes.begin(), boxes.end());
  };
  EXPECT_EQ(sorted_by_tile(table, 1e6, {2, {}}, take).tiles.size(), 4u);
  EXPECT_EQ(taken, expected);
}

TEST(TileSort, GivesEachTileItsBoxesAndTheBoxAroundThem) {
  const BoxTable table = table_of(5, 3000, 400);
  const SortedBoxes sorted = sorted_by_tile(table, 50, {}, [](std::span<const Aabb>) {});
  std::size_t next = 0;
  for (const Tile& tile : sorted.tiles) {
    ASSERT_EQ(tile.first, next);
    ASSERT_GT(tile.count, 0u);
    const auto boxes = sorted.boxes->boxes.all().subspan(tile.first, tile.count);
    EXPECT_EQ(tile.extent, *bounds(boxes));
    for (const Aabb& box : boxes) EXPECT_EQ(place_of(box, 50), place_of(tile));
    next += tile.count;
  }
  EXPECT_EQ(next, table.boxes.size());
}

TEST(TileSort, OfNothingIsNothing) {
  const auto none = [](std::span<const Aabb> boxes) { EXPECT_TRUE(boxes.empty()); };
  EXPECT_TRUE(sorted_by_tile(BoxTable(), 100, {}, none).tiles.empty());
}

}  // namespace
}  // namespace geom
