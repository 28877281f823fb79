#include "roadmap/edge_lists.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plan {
namespace {

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
