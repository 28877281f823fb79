#include "geom/map/box_sdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "geom/import/sdf_world.h"
#include "geom/map/make_map.h"
#include "support/reading.h"

namespace geom {
namespace {

std::string written(const BoxMap& map) {
  std::ostringstream out;
  EXPECT_EQ(write_box_sdf(out, map), 0u);
  return out.str();
}

BoxMap read_back(const std::string& text) {
  SdfWorld world = read_sdf_world(support::Text(text), "w", {});
  MakeMapOptions options;
  options.source_bounds = world.bounds;
  options.floor = world.floor;
  return make_map(world.table, world.frame, "[]", "w", options).map;
}

BoxMap random_map(const Frame& frame, double least = 1) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(least, 900);
  std::uniform_real_distribution<double> size(0, 30);
  BoxTable table;
  const std::vector<std::string> labels = {"",           "a \"b\" <c> & d", "x::y",
                                           " blank ",    "__m__",           "world",
                                           "two\nlines", "ground_plane",    "boxes_0"};
  for (std::size_t i = 0; i < 3000; ++i) {
    const Vec3 low(place(random), place(random), i % 3 ? 0 : place(random));
    const Vec3 extent(size(random), i % 7 ? size(random) : 0, size(random));
    table.add({low, low + extent}, i, table.label_of(labels[i % labels.size()]));
  }
  MakeMapOptions options;
  options.pad = 3;
  return make_map(table, frame, "[]", "m", options).map;
}

void expect_same(const BoxMap& a, const BoxMap& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.boxes()[i], b.boxes()[i]) << i;
    ASSERT_EQ(a.labels()[a.label()[i]], b.labels()[b.label()[i]]) << i;
  }
  EXPECT_EQ(a.spec().bounds, b.spec().bounds);
  EXPECT_EQ(a.spec().frame, b.spec().frame);
  EXPECT_EQ(a.hash(), b.hash());
}

TEST(BoxSdf, ComesBackBitForBit) {
  for (const Frame& frame :
       {Frame{}, Frame{Axes::enu, GeodeticOrigin{47.39797, 8.546163739800146, 400.5}, ""},
        Frame{Axes::enu, GeodeticOrigin{52, 4, 0}, "EPSG:28992"}}) {
    const BoxMap map = random_map(frame);
    const std::string text = written(map);
    const BoxMap back = read_back(text);
    expect_same(map, back);
    EXPECT_EQ(written(back).size(), text.size());
    expect_same(back, read_back(written(back)));
  }
}

TEST(BoxSdf, IsInEastNorthUp) {
  const BoxMap map = random_map({Axes::neu, GeodeticOrigin{37, -122, 0}, ""});
  const BoxMap back = read_back(written(map));
  EXPECT_EQ(back.spec().frame.axes, Axes::enu);
  ASSERT_EQ(back.size(), map.size());
  EXPECT_EQ(back.spec().bounds, to_enu(Axes::neu, map.spec().bounds));
  expect_same(back, read_back(written(back)));
}

// Of boxes that reach across 0 some are an ulp larger; what came back stays.
TEST(BoxSdf, IsNeverSmaller) {
  const BoxMap map = random_map({}, -20);
  std::ostringstream out;
  const std::size_t larger = write_box_sdf(out, map);
  EXPECT_LT(larger, map.size() / 20);
  const BoxMap back = read_back(out.str());
  ASSERT_EQ(back.size(), map.size());
  std::size_t same = 0;
  for (const Aabb& box : map.boxes()) {
    const auto holds = [&](const Aabb& other) {
      return contains(other, box.min) && contains(other, box.max) &&
             (other.max - other.min - box.max + box.min).maxCoeff() < 1e-12;
    };
    ASSERT_TRUE(std::any_of(back.boxes().begin(), back.boxes().end(), holds));
    same += std::find(back.boxes().begin(), back.boxes().end(), box) != back.boxes().end();
  }
  EXPECT_EQ(same, map.size() - larger);
  expect_same(back, read_back(written(back)));
}

TEST(BoxSdf, StandsOnItsFloor) {
  const BoxMap map = random_map({});
  const SdfWorld world = read_sdf_world(support::Text(written(map)), "w", {});
  EXPECT_EQ(world.floor, map.spec().bounds.min.z());
  EXPECT_EQ(world.movable, 0u);
  EXPECT_TRUE(world.skipped.empty());
}

}  // namespace
}  // namespace geom
