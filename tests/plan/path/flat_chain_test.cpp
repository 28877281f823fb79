#include "path/flat_chain.h"

#include <gtest/gtest.h>

namespace plan {
namespace {

TEST(FlatChain, PassesOverAllPointsAndKeepsThoseItTurnsAt) {
  const Flat first{0, 0, {}};
  const Flat last{10, 0, {}};
  const auto chain = upper_chain({{5, 1, {}}, {2, 3, {}}, {8, 3, {}}, {2, 1, {}}}, first, last);
  ASSERT_EQ(chain.size(), 4u);
  EXPECT_EQ(chain[1].u, 2);
  EXPECT_EQ(chain[1].w, 3);
  EXPECT_EQ(chain[2].u, 8);
  EXPECT_EQ(upper_chain({}, first, last).size(), 2u);
}

TEST(FlatChain, FindsWhereEdgesOfABoxPassThroughAPlane) {
  const geom::Aabb box{{1, 1, 1}, {3, 5, 9}};
  int points = 0;
  for_edges_through(box, {2, 0, 0}, {1, 0, 0}, [&](const Vec3& p) {
    ++points;
    EXPECT_EQ(p.x(), 2);
    EXPECT_TRUE(p.y() == 1 || p.y() == 5);
    EXPECT_TRUE(p.z() == 1 || p.z() == 9);
  });
  EXPECT_EQ(points, 4);
  for_edges_through(box, {4, 0, 0}, {1, 0, 0}, [](const Vec3&) { FAIL(); });
}

}  // namespace
}  // namespace plan
