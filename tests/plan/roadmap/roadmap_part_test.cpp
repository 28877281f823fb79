#include "plan/roadmap/roadmap_part.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

constexpr std::size_t kCounts[] = {1, 2, 3, 7, 60};  // 60: more than tiles

class RoadmapPartsProperty : public testing::TestWithParam<std::uint64_t> {
 protected:
  geom::CollisionScene scene_ = random_scene(GetParam(), 60, 90, {0.5, 0.5, 0.25});
};

TEST_P(RoadmapPartsProperty, MakeTheRoadmapBitForBit) {
  std::vector<RoadmapSpec> specs(3);
  specs[0].reach = 25;
  specs[1].reach = 500;
  specs[2].reach = 30;
  specs[2].region = geom::Aabb{{20, 10, 0}, {70, 80, 60}};
  for (const RoadmapSpec& spec : specs) {
    const std::string whole = bytes(build_roadmap(scene_, spec));
    for (const std::size_t count : kCounts) {
      std::vector<RoadmapPart> parts;
      for (std::size_t k = 0; k < count; ++k) {
        parts.push_back(through_file(build_roadmap_part(scene_, spec, {k, count}, {2, {}})));
      }
      EXPECT_EQ(bytes(join_roadmap(parts, {2, {}})), whole) << count << " shards";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cities, RoadmapPartsProperty, testing::Values(1, 2, 3));

std::vector<RoadmapPart> two_of(const geom::CollisionScene& scene, const RoadmapSpec& spec) {
  std::vector<RoadmapPart> parts;
  for (const std::size_t k : {0u, 1u}) parts.push_back(build_roadmap_part(scene, spec, {k, 2}));
  return parts;
}

TEST(RoadmapParts, ThatDoNotFitAreRefused) {
  const auto scene = random_scene(4, 60, 90, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const auto good = two_of(scene, spec);
  ASSERT_FALSE(good[0].near_box.empty());
  const auto refused = [&](const auto& spoil) {
    auto parts = good;
    spoil(parts);
    EXPECT_THROW(join_roadmap(parts), geom::InputError);
  };
  EXPECT_NO_THROW(join_roadmap(good));
  refused([](auto& parts) { std::swap(parts[0], parts[1]); });
  refused([](auto& parts) { parts[1].boxes = 7; });
  refused([](auto& parts) { ++parts[1].bends_of[0]; });
  refused([](auto& parts) { ++parts[0].near_bends[0]; });
  refused([](auto& parts) { parts[0].near_box[0] = 0xffffffff; });
  const auto with_edge = [](RoadmapPart& part, std::uint32_t to) {
    std::vector<std::vector<std::uint32_t>> lists(part.bends.size());
    for (std::size_t i = 0; i < lists.size(); ++i) {
      lists[i].assign(part.edges.of(i).begin(), part.edges.of(i).end());
    }
    lists[0].push_back(to);
    part.edges = flat(std::move(lists));
  };
  refused([&](auto& parts) { with_edge(parts[0], 0); });
  refused([&](auto& parts) { with_edge(parts[0], 0xfffffffe); });
  refused([](auto& parts) { parts[1].coarse.reset(); });
}

TEST(EdgeLists, AreThoseOfEachBendOneAfterTheOther) {
  const EdgeLists edges = flat({{4, 2}, {}, {7}});
  EXPECT_TRUE(std::ranges::equal(edges.first, std::vector<std::uint64_t>{0, 2, 2, 3}));
  EXPECT_TRUE(std::ranges::equal(edges.of(0), std::vector<std::uint32_t>{4, 2}));
  EXPECT_TRUE(edges.of(1).empty());
  EXPECT_TRUE(std::ranges::equal(edges.of(2), std::vector<std::uint32_t>{7}));
  EXPECT_EQ(flat({}).first.size(), 1u);
}

}  // namespace
}  // namespace plan
