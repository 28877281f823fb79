#include "collision/top_cells.h"

#include <gtest/gtest.h>

#include "collision/box_walk.h"
#include "support/cases.h"
#include "support/random_city.h"

namespace geom {
namespace {

struct World {
  std::vector<Aabb> boxes;
  TreeFrame frame;
  HugeArena arena;
  TopCells cells;

  explicit World(std::vector<Aabb> all)
      : boxes(std::move(all)), frame(*bounds(boxes)), cells(boxes, frame, arena) {}
};

// Squares of about 100 m side by side, some with a bit that reaches out.
std::vector<Aabb> squares(std::uint64_t seed, int side, const Vec3& corner) {
  support::Random random(seed);
  std::vector<Aabb> out;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Vec3 low = corner + Vec3(100 * x, 100 * y, 0);
      out.push_back({low - Vec3(random.below(30), random.below(2), 0),
                     low + Vec3(100, 100 + random.below(30), random.below(200))});
    }
  }
  return out;
}

// Whether the node of the cell has each box that the segment meets.
void expect_all_on(const World& w, const Vec3& a, const Vec3& b, const BoxNode& node) {
  std::vector<int> asked(w.boxes.size());
  const SegmentInTree s(w.frame, a, b);
  any_meeting<lanes::Plain>(&node, s, [&](std::size_t k) {
    ++asked[k];
    return false;
  });
  for (std::size_t k = 0; k < w.boxes.size(); ++k) {
    EXPECT_LE(asked[k], 1);
    if (segment_hits(a, b, w.boxes[k])) {
      EXPECT_EQ(asked[k], 1);
    }
  }
}

TEST(TopCells, HaveEachBoxThatASegmentMeets) {
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(-1234.5, 5e5, 10), Vec3(4e6, -3e6, 0)}) {
    const World w(squares(1, 30, corner));
    support::Random random(2);
    int found = 0;
    for (int i = 0; i < support::cases(2000); ++i) {
      const auto along = [&] {
        return random.below(2) ? random.stepped(-100, 3100, 50) : random.uniform(-100, 3100);
      };
      const Vec3 a = corner + Vec3(along(), along(), random.uniform(0, 200));
      const Vec3 b =
          random.below(3) ? Vec3(a + Vec3(random.uniform(-40, 40), random.uniform(-40, 40), 0)) : a;
      const BoxNode* const node = w.cells.node(a, b);
      if (!node) continue;
      ++found;
      expect_all_on(w, a, b, *node);
      if (HasFailure()) FAIL() << "case " << i;
    }
    EXPECT_GT(found, support::cases(2000) / 2);
  }
}

TEST(TopCells, AreNoneOfTwoPointsInTwo) {
  const World w(squares(1, 30, Vec3::Zero()));
  EXPECT_EQ(w.cells.node({10, 10, 5}, {2000, 10, 5}), nullptr);
  EXPECT_EQ(w.cells.node({10, 10, 5}, {10, 2000, 5}), nullptr);
}

// Where they lie close, one child a node is not enough.
TEST(TopCells, AreNoneWhereMoreReachIntoThemThanANodeHas) {
  std::vector<Aabb> boxes = squares(1, 30, Vec3::Zero());
  for (int i = 0; i < 20; ++i) boxes.push_back({{10, 10, 0}, {20, 20, 5.0 + i}});
  const World w(boxes);
  EXPECT_EQ(w.cells.node({15, 15, 3}, {15, 15, 3}), nullptr);
  EXPECT_NE(w.cells.node({1500, 1500, 3}, {1500, 1500, 3}), nullptr);
}

TEST(TopCells, AreNoneWhereManyReachOverAll) {
  std::vector<Aabb> boxes = squares(1, 30, Vec3::Zero());
  for (int i = 0; i < 900; ++i) boxes.push_back({{0, 0, 0}, {3000, 3000, 5.0 + i}});
  const World w(boxes);
  EXPECT_EQ(w.cells.node({1500, 1500, 3}, {1500, 1500, 3}), nullptr);
}

TEST(TopCells, MayBeOfFewOrFlatBoxes) {
  HugeArena arena;
  EXPECT_EQ(TopCells({}, TreeFrame(), arena).node({0, 0, 0}, {0, 0, 0}), nullptr);
  for (const Aabb& box : {Aabb{{5, 5, 5}, {5, 5, 5}}, Aabb{{-1e8, 0, 0}, {1e8, 0, 0}}}) {
    const World w({box});
    const BoxNode* const node = w.cells.node(box.min, box.min);
    if (node) expect_all_on(w, box.min, box.min, *node);
  }
}

}  // namespace
}  // namespace geom
