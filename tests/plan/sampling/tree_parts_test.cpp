#include "plan/sampling/tree_parts.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

TEST(TreeParts, AreOneForEachTreeThatHasNodes) {
  SearchTreeRecord record;
  record.id = "q1";
  record.tree = {.points = {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {2, 0, 0}},
                 .parent = {0, 1, 0, 2},
                 .tree = {0, 1, 0, 0}};
  const auto parts = tree_parts(record, geom::Axes::enu, 0.3);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, "tree q1 from the start");
  EXPECT_EQ(parts[0].triangles, 3 * 128u + 2 * 16u);  // spheres, and edges between them
  EXPECT_EQ(parts[1].name, "tree q1 from the goal");
  EXPECT_EQ(parts[1].triangles, 128u);
  record.tree.tree = {0, 0, 0, 0};
  EXPECT_EQ(tree_parts(record, geom::Axes::enu, 0.3).size(), 1u);
}

}  // namespace
}  // namespace plan
