#include "plan/roadmap/part_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/error.h"
#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

TEST(RoadmapPartFile, ComesBackWithItsLattice) {
  const auto scene = random_scene(2, 60, 90, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const RoadmapPart part = build_roadmap_part(scene, spec, {0, 2});
  const RoadmapPart back = through_file(part);
  EXPECT_EQ(back.spec.reach, 40);
  EXPECT_EQ(back.boxes, part.boxes);
  EXPECT_EQ(back.bends_of, part.bends_of);
  ASSERT_FALSE(part.near_box.empty());
  EXPECT_EQ(back.near_box, part.near_box);
  EXPECT_EQ(back.near_bends, part.near_bends);
  EXPECT_TRUE(std::ranges::equal(back.edges.to, part.edges.to));
  EXPECT_EQ(back.coarse.has_value(), part.coarse.has_value());
  EXPECT_EQ(arrays_and_meta(arrays_of(back)), arrays_and_meta(arrays_of(part)));
}

TEST(RoadmapPartFile, WhoseArraysDoNotFitIsRefused) {
  const auto scene = random_scene(2, 60, 90, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const RoadmapPart good = build_roadmap_part(scene, spec, {0, 2});
  const auto refused = [&](const auto& spoil) {
    RoadmapPart part = good;
    std::vector<std::uint64_t> first(good.edges.first.begin(), good.edges.first.end());
    spoil(part, first);
    part.edges.first = first;
    EXPECT_THROW(through_file(part), geom::InputError);
  };
  EXPECT_NO_THROW(through_file(good));
  refused([](RoadmapPart& part, auto&) { part.near_bends.pop_back(); });
  refused([](RoadmapPart& part, auto&) { part.edges.to = part.edges.to.first(1); });
  refused([](RoadmapPart&, auto& first) { first.pop_back(); });
  refused([](RoadmapPart&, auto& first) { first[0] = 1; });
  refused([](RoadmapPart&, auto& first) { first[1] = first.back() + 1; });
}

}  // namespace
}  // namespace plan
