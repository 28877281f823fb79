#include "plan/roadmap/part_file.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "plan/roadmap/roadmap_part.h"
#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

TEST(RoadmapPartFile, WhoseArraysDoNotFitIsRefused) {
  const auto scene = random_scene(2, 60, 400, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const Roadmap good = build_roadmap_part(scene, spec, {0, 2});
  const auto refused = [&](const auto& spoil) {
    Roadmap part = good;
    std::vector<std::uint64_t> first(good.tile_first.begin(), good.tile_first.end());
    part.tile_first = first;
    spoil(part, first);
    EXPECT_THROW(through_file(part), geom::InputError);
  };
  EXPECT_NO_THROW(through_file(good));
  refused([](Roadmap& part, auto&) { part.edge_split = part.edge_split.first(1); });
  refused([](Roadmap& part, auto&) { part.edge_to = part.edge_to.first(1); });
  refused([](Roadmap& part, auto&) { part.tile_extent = part.tile_extent.first(6); });
  refused([](Roadmap&, auto& first) { first[0] = 1; });
  refused([](Roadmap&, auto& first) { first[1] = first.back() + 1; });
}

}  // namespace
}  // namespace plan
