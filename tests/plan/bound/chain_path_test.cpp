#include "bound/chain_path.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

const EdgePart kEdge{{5, 5, 0}, {5, 5, 9}, 2, {1, -1}};

TEST(ChainPath, WithoutPartsIsTheLine) {
  EXPECT_EQ(chain_path({}, {1, 2, 3}, {4, 5, 6}), (geom::Polyline{{1, 2, 3}, {4, 5, 6}}));
}

TEST(ChainPath, BendsWhereTheWayIsShortestAMillimetreOutside) {
  const auto path = chain_path({kEdge}, {5, 2, 1}, {9, 5, 8});  // 3 m and 4 m from the edge
  ASSERT_EQ(path.size(), 3u);
  EXPECT_NEAR((path[1] - Vec3(5.001, 4.999, 4)).norm(), 0, 1e-12);
}

TEST(ChainPath, StaysOnItsParts) {
  const auto path = chain_path({kEdge}, {5, 2, 20}, {9, 5, 30});
  EXPECT_NEAR((path[1] - Vec3(5.001, 4.999, 9)).norm(), 0, 1e-12);
}

TEST(ChainPath, GoesThroughCorners) {
  const EdgePart corner{{7, 7, 7}, {7, 7, 7}, kCorner, {}};
  EXPECT_EQ(chain_path({corner}, {0, 0, 0}, {9, 9, 9})[1], Vec3(7, 7, 7));
}

}  // namespace
}  // namespace plan
