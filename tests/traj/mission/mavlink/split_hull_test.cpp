#include "mission/mavlink/split_hull.h"

#include <gtest/gtest.h>

#include <random>

#include "geom/shape/aabb.h"
#include "geom/shape/hull.h"

namespace traj {
namespace {

bool holds(const Hull& hull, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(1e-6);
  return geom::hull_meets(hull, {p - hair, p + hair}).has_value();
}

TEST(SplitHull, CutsALegIntoPieces) {
  const std::vector<Hull> pieces = split_hull({{0, 0, 1}, {100, 0, 11}}, 25);
  ASSERT_EQ(pieces.size(), 4u);
  EXPECT_EQ(pieces[0].size(), 2u);
  EXPECT_TRUE(holds(pieces[3], {75, 0, 8.5}));
}

TEST(SplitHull, LeavesAColumnWhole) {
  const Hull column{{3, 3, 0}, {3, 3, 500}};
  EXPECT_EQ(split_hull(column, 5), std::vector<Hull>{column});
}

TEST(SplitHull, ThePiecesHoldAllOfTheHullAndAreSmall) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-60, 60);
  std::uniform_real_distribution<double> weight(0, 1);
  for (int round = 0; round < 40; ++round) {
    Hull hull;
    for (int i = 0; i < 2 + round % 12; ++i) {
      hull.emplace_back(place(random), place(random), place(random));
    }
    const std::vector<Hull> pieces = split_hull(hull, 20);
    for (const Hull& piece : pieces) {
      const geom::Aabb box = *geom::bounds(piece);
      EXPECT_LE((box.max - box.min).head<2>().maxCoeff(), 20 + 1e-9);
    }
    for (int k = 0; k < 60; ++k) {
      Vec3 p = Vec3::Zero();
      double sum = 0;
      for (const Vec3& corner : hull) {
        const double w = -std::log(weight(random) + 1e-300);
        p += w * corner;
        sum += w;
      }
      p /= sum;
      EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(),
                              [&](const Hull& piece) { return holds(piece, p); }))
          << "round " << round << ": " << p.transpose();
    }
  }
}

}  // namespace
}  // namespace traj
