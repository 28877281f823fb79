#include "plan/lattice/visible_nodes.h"

#include <gtest/gtest.h>

#include "plan/lattice/build_lattice.h"
#include "plan/scenes.h"

namespace plan {
namespace {

// Nodes at whole multiples of 10 m; the wall hides those beyond x = 14.
const geom::CollisionScene& scene() {
  static const geom::CollisionScene made =
      scene_of({{{14, 0, 0}, {16, 100, 100}}}, {{0, 0, 0}, {100, 100, 100}});
  return made;
}

const Lattice& lattice() {
  static const Lattice made = build_lattice(scene(), {10, Connectivity::six, Vec3::Zero()});
  return made;
}

std::vector<Terminal> visible(const Vec3& p, Rings rings) {
  AstarSearch search(lattice());
  return visible_nodes(scene(), lattice(), search, p, rings);
}

TEST(VisibleNodes, AreTheCornersOfTheCellThatSeeThePoint) {
  const auto nodes = visible({13, 25, 25}, Rings::nearest);
  ASSERT_EQ(nodes.size(), 4u);
  for (const Terminal& node : nodes) {
    const Vec3 position = lattice().position(node.node);
    EXPECT_EQ(position.x(), 10);
    EXPECT_EQ(node.cost, (position - Vec3(13, 25, 25)).norm());
  }
}

TEST(VisibleNodes, AreOfAllRingsWhereAsked) {
  // x = 0 and 10; along y and z the nodes from -20 to 70, of which those below 0 are outside.
  EXPECT_EQ(visible({13, 25, 25}, Rings::all).size(), 2 * 8 * 8u);
}

TEST(VisibleNodes, AreNoneOfAnEndThatIsBlocked) {
  EXPECT_TRUE(visible({15, 25, 25}, Rings::all).empty());
}

}  // namespace
}  // namespace plan
