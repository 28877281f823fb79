#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/sha256.h"
#include "geom/map/box_map.h"
#include "support/edited_map.h"
#include "support/random_city.h"

namespace geom {
namespace {

using support::EditedMap;
using support::Random;

BoxMap city(std::uint64_t seed, int count, double side, double tile_size) {
  const BoxMap map = support::random_city(seed, count, side);
  BoxMapSpec spec = map.spec();
  spec.tile_size = tile_size;
  return BoxMap(spec, support::table_of({map.boxes().begin(), map.boxes().end()}));
}

// As docs/formats.md defines it.
std::string hash_by_sorting(const BoxMap& map) {
  std::vector<Aabb> boxes(map.boxes().begin(), map.boxes().end());
  std::sort(boxes.begin(), boxes.end(), [](const Aabb& a, const Aabb& b) {
    return std::lexicographical_compare(a.min.data(), a.min.data() + 6, b.min.data(),
                                        b.min.data() + 6);
  });
  Sha256 sum;
  const auto add = [&](const void* data, std::size_t size) {
    sum.update({static_cast<const std::byte*>(data), size});
  };
  const std::string head =
      std::string(name(map.spec().frame.axes)) + "\n" + map.spec().frame.crs + "\n";
  add(head.data(), head.size());
  if (const auto& at = map.spec().frame.origin) {
    for (const double v : {at->latitude, at->longitude, at->height}) add(&v, sizeof v);
  }
  add(&map.spec().bounds, sizeof(Aabb));
  add(boxes.data(), boxes.size() * sizeof(Aabb));
  return "sha256:" + sum.hex();
}

TEST(MapHash, IsThatOfTheSortedBoxesForTilesOfAnySize) {
  Random random(5);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const BoxMap some = support::random_city(seed, random.below(400), random.stepped(50, 900, 50));
    BoxMapSpec spec = some.spec();
    if (seed % 2) spec.frame.origin = GeodeticOrigin{60, 25, 3};
    spec.frame.crs = seed % 3 ? "EPSG:3879" : "";
    std::vector<Aabb> boxes(some.boxes().begin(), some.boxes().end());
    if (!boxes.empty()) boxes.insert(boxes.end(), 3, boxes[boxes.size() / 2]);
    std::string hash;
    for (const double size : {1.0, 7.5, 33.0, 100.0, 1e6}) {
      spec.tile_size = size;
      const BoxMap map(spec, support::table_of(boxes));
      if (hash.empty()) hash = hash_by_sorting(map);
      ASSERT_EQ(map.hash(), hash) << "seed " << seed << ", tiles of " << size << " m";
      const BoxMap back = EditedMap(map).map();
      back.require(Verified::contents, {2, {}});
    }
  }
}

TEST(MapHash, IsTheSameWhereAColumnIsTooLongToBeHeld) {
  const BoxMap map = city(13, 300000, 4000, 1e6);
  EXPECT_EQ(map.hash(), hash_by_sorting(map));
  const BoxMap rows = city(13, 300000, 4000, 3900);  // two columns or three, each of several tiles
  EXPECT_EQ(rows.hash(), map.hash());
}

}  // namespace
}  // namespace geom
