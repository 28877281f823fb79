#include "plan/roadmap/roadmap_part.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

constexpr std::size_t kCounts[] = {1, 2, 3, 7, 60};  // 60: more than tiles

class RoadmapPartsProperty : public testing::TestWithParam<std::uint64_t> {
 protected:
  geom::CollisionScene scene_ = random_scene(GetParam(), 60, 400, {0.5, 0.5, 0.25});
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
      std::vector<Roadmap> parts;
      for (std::size_t k = 0; k < count; ++k) {
        parts.push_back(through_file(build_roadmap_part(scene_, spec, {k, count}, {2, {}})));
      }
      EXPECT_EQ(bytes(parts), whole) << count << " shards";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cities, RoadmapPartsProperty, testing::Values(1, 2, 3));

std::vector<Roadmap> two_of(const geom::CollisionScene& scene, const RoadmapSpec& spec) {
  std::vector<Roadmap> parts;
  for (const std::size_t k : {0u, 1u}) parts.push_back(build_roadmap_part(scene, spec, {k, 2}));
  return parts;
}

TEST(RoadmapParts, ThatDoNotFitAreRefused) {
  const auto scene = random_scene(4, 60, 400, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const auto good = two_of(scene, spec);
  ASSERT_GT(good[0].tiles(), 1u);
  ASSERT_GT(good[1].tiles(), 1u);
  const auto refused = [&](const auto& spoil) {
    auto parts = good;
    std::vector<std::uint64_t> first(good[1].tile_first.begin(), good[1].tile_first.end());
    std::vector<std::uint64_t> edges(good[1].tile_edges.begin(), good[1].tile_edges.end());
    parts[1].tile_first = first;
    parts[1].tile_edges = edges;
    spoil(parts, first, edges);
    EXPECT_THROW(bytes(parts), geom::InputError);
  };
  EXPECT_NO_THROW(bytes(good));
  refused([](auto& parts, auto&, auto&) { std::swap(parts[0], parts[1]); });
  refused([](auto& parts, auto&, auto&) { parts[1] = parts[0]; });
  refused([](auto& parts, auto&, auto&) { parts[0].spec.reach = 41; });
  refused([](auto& parts, auto&, auto&) { parts[0].made_for.map = "another"; });
  refused([](auto&, auto& first, auto&) { --first.back(); });
  refused([](auto&, auto& first, auto&) { ++first.back(); });
  refused([](auto&, auto& first, auto&) { first[0] = 1; });
  refused([](auto&, auto& first, auto&) { first[1] = first[2] + 1; });
  refused([](auto&, auto&, auto& edges) { --edges.back(); });
  refused([](auto&, auto&, auto& edges) { edges[1] = edges[2] + 1; });
}

}  // namespace
}  // namespace plan
