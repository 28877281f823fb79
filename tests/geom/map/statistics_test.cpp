#include "geom/map/statistics.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_of(const BoxTable& table) {
  return {{.bounds = {{-1000, -1000, 0}, {1000, 1000, 100}}}, table};
}

TEST(MapStatistics, CountHeightsTilesFlatBoxesAndUnknowns) {
  BoxTable table;
  table.add({{0, 0, 0}, {1, 1, 3}}, 1);
  table.add({{5, 0, 0}, {5, 1, 5}}, 2, table.label_of("unknown"));  // flat
  table.add({{210, 0, 10}, {211, 1, 20}}, 3, table.label_of("tree"));
  table.add({{2, 0, 0}, {3, 1, 14}}, 4, table.label_of("unknown"));
  const MapStatistics out = statistics(map_of(table));
  EXPECT_EQ(out.height.least, 3);
  EXPECT_EQ(out.height.median, 5) << "of an even number the lower";
  EXPECT_EQ(out.height.mean, 8);
  EXPECT_EQ(out.height.most, 14);
  EXPECT_EQ(out.boxes_per_tile.least, 1) << "two tiles of 100 m, of three boxes and one";
  EXPECT_EQ(out.boxes_per_tile.mean, 2);
  EXPECT_EQ(out.boxes_per_tile.most, 3);
  EXPECT_EQ(out.flat, 1u);
  EXPECT_EQ(out.unknown, 2u);
}

TEST(MapStatistics, AreZeroOfAnEmptyMap) {
  const MapStatistics out = statistics(map_of({}));
  EXPECT_EQ(out.height.most, 0);
  EXPECT_EQ(out.boxes_per_tile.mean, 0);
  EXPECT_EQ(overlaps(map_of({})).pairs, 0u);
}

TEST(Overlaps, AreOfInteriorsAndOfEqualBoxesAllButOneAreContained) {
  const Aabb box{{0, 0, 0}, {4, 4, 4}};
  const auto of = [](std::vector<Aabb> boxes) {
    return overlaps(map_of(support::table_of(std::move(boxes))));
  };
  EXPECT_EQ(of({box, {{4, 0, 0}, {8, 4, 4}}}).pairs, 0u) << "side by side";
  EXPECT_EQ(of({box, {{3, 0, 0}, {8, 4, 4}}}).pairs, 1u);
  EXPECT_EQ(of({box, {{3, 0, 0}, {8, 4, 4}}}).contained, 0u);
  EXPECT_EQ(of({box, {{0, 1, 0}, {1, 2, 4}}}).contained, 1u);
  EXPECT_EQ(of({box, box, box}).contained, 2u);
  EXPECT_EQ(of({box, box, box}).pairs, 3u);
}

TEST(Overlaps, AgreeWithALookAtEveryPair) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    BoxTable table = support::table_of({});
    for (const Aabb& box : support::random_city(seed, 150, 60).boxes()) {
      if ((box.min.array() < box.max.array()).all()) table.add(box, table.boxes.size());
    }
    const BoxMap map = map_of(table);
    Overlaps expected;
    for (std::size_t i = 0; i < map.size(); ++i) {
      bool contained = false;
      for (std::size_t k = 0; k < map.size(); ++k) {
        const Aabb& a = map.boxes()[i];
        const Aabb& b = map.boxes()[k];
        const Vec3 shared = a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min);
        expected.pairs += i < k && shared.minCoeff() > 0;
        contained = contained || (i != k && merged(a, b) == b && (!(a == b) || k < i));
      }
      expected.contained += contained;
    }
    EXPECT_EQ(overlaps(map).pairs, expected.pairs) << "seed " << seed;
    EXPECT_EQ(overlaps(map).contained, expected.contained) << "seed " << seed;
  }
}

}  // namespace
}  // namespace geom
