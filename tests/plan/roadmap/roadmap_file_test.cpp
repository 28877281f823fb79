#include "plan/roadmap/roadmap_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/file_bytes.h"
#include "plan/roadmap/roadmap.h"
#include "plan/scenes.h"
#include "roadmap/squares.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace plan {
namespace {

class RoadmapFileProperty : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RoadmapFileProperty, ComesBack) {
  const auto scene = small_city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, {});
  const std::string file = bytes(roadmap);
  const Roadmap back =
      read_roadmap(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(file)), "test.roadmap"));
  EXPECT_TRUE(std::ranges::equal(back.edge_to, roadmap.edge_to));
  EXPECT_TRUE(std::ranges::equal(back.edge_first, roadmap.edge_first));
  EXPECT_TRUE(std::ranges::equal(back.edge_split, roadmap.edge_split));
  ASSERT_EQ(back.bends(), roadmap.bends());
  EXPECT_EQ(back.made_for.map, scene.map().hash());
}

INSTANTIATE_TEST_SUITE_P(Cities, RoadmapFileProperty, testing::Values(1, 2, 3));

TEST(RoadmapFile, RefusesAnEdgeThatLeadsNowhere) {
  const auto scene = small_city(1);
  Roadmap roadmap = build_roadmap(scene, {10, 60, {}});
  std::vector<std::uint32_t> to(roadmap.edge_to.begin(), roadmap.edge_to.end());
  to[5] |= Squares::kLocalMask;
  roadmap.edge_to = to;
  const std::string file = bytes(roadmap);
  const Roadmap back =
      read_roadmap(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(file)), "t.roadmap"));
  EXPECT_TRUE(support::says(support::refusal_of([&] { verify_roadmap(back); }),
                            "t.roadmap: an edge leads to bend"));
}

// A search that meets the edge refuses it, rather than follow it.
TEST(RoadmapFile, IsNotFollowedWhereItLeadsNowhere) {
  const auto scene = small_city(1);
  Roadmap roadmap = build_roadmap(scene, {});
  const std::vector<std::uint32_t> to(roadmap.edge_to.size(), 0xffffffff);
  roadmap.edge_to = to;
  RoadmapSearch search(scene, roadmap);
  support::Random random(1);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 from(random.uniform(-150, 150), random.uniform(-150, 150), random.uniform(1, 20));
    const Vec3 to_there(random.uniform(-150, 150), random.uniform(-150, 150), 5);
    if (!scene.free(from) || !scene.free(to_there) || scene.free(from, to_there)) continue;
    refused += !support::refusal_of([&] { search.search(from, to_there, {}); }).empty();
  }
  EXPECT_GT(refused, 10);
}

TEST(RoadmapFile, KeepsTheRegion) {
  const auto scene =
      scene_of({{{5, 5, 0}, {9, 9, 9}}}, {{0, 0, 0}, {60, 60, 30}}, {0.5, 0.5, 0.25});
  const Roadmap roadmap = build_roadmap(scene, {10, 100, geom::Aabb{{1, 2, 3}, {40, 50, 20}}});
  const std::string written = bytes(roadmap);
  const Roadmap back =
      read_roadmap(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(written)), "test"));
  EXPECT_EQ(back.spec.region, roadmap.spec.region);
  EXPECT_EQ(bytes(back), written);
}

}  // namespace
}  // namespace plan
