#include "plan/lattice/part_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

TEST(LatticePartFile, ComesBack) {
  const auto scene = random_scene(1, 60, 90, {0.5, 0.5, 0.25});
  const LatticePart part = build_lattice_part(scene, {1.5}, {1, 3});
  const LatticePart back = through_file(part);
  EXPECT_EQ(back.shard.index, 1u);
  EXPECT_EQ(back.shard.count, 3u);
  EXPECT_EQ(back.grid.spec.spacing, 1.5);
  EXPECT_EQ(back.blocks.counts.edges, part.blocks.counts.edges);
  EXPECT_EQ(geom::mismatch(back.made_for, part.made_for), std::nullopt);
  ASSERT_FALSE(part.blocks.records.empty());
  EXPECT_TRUE(std::ranges::equal(back.blocks.record, part.blocks.record));
  EXPECT_TRUE(std::ranges::equal(back.blocks.records, part.blocks.records));
  EXPECT_EQ(arrays_and_meta(arrays_of(back)), arrays_and_meta(arrays_of(part)));
}

}  // namespace
}  // namespace plan
