#include "map/cover_upright.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solid_oracle.h"

namespace geom {
namespace {

using oracle::any_holds;
using oracle::solid_under;

std::vector<Aabb> covered(const Footprint& f, double slack) {
  return cover_upright(f, fit_plane(corners_of(f)), slack, BoxRuns());
}

TEST(CoverUpright, AWallIsOneBox) {
  const auto boxes = covered(solid_under({{0, 0, 0}, {9, 0, 0}, {9, 0, 5}, {0, 0, 5}}), 0.5);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].max.z(), 5);
  EXPECT_LT(boxes[0].max.y() - boxes[0].min.y(), 1e-6);
}

TEST(CoverUpright, FollowsAGableAndABattlement) {
  const auto gable =
      covered(solid_under({{0, 0, 0}, {8, 0, 0}, {8, 0, 4}, {4, 0, 8}, {0, 0, 4}}), 0.5);
  EXPECT_TRUE(any_holds(gable, {4, 0, 8}));
  EXPECT_FALSE(any_holds(gable, {1, 0, 6}));
  const auto battlement = covered(
      solid_under(
          {{0, 0, 0}, {6, 0, 0}, {6, 0, 9}, {4, 0, 9}, {4, 0, 5}, {2, 0, 5}, {2, 0, 9}, {0, 0, 9}}),
      0.5);
  EXPECT_TRUE(any_holds(battlement, {1, 0, 9}));
  EXPECT_TRUE(any_holds(battlement, {3, 0, 5}));
  EXPECT_FALSE(any_holds(battlement, {3, 0, 7}));
}

TEST(CoverUpright, APoleIsABoxToo) {
  EXPECT_TRUE(any_holds(covered(solid_under({{3, 3, 0}, {3, 3, 9}, {3, 3, 4}}), 0.5), {3, 3, 9}));
}

TEST(CoverUpright, LeavesOutWhatOthersHold) {
  const Footprint f = solid_under({{0, 0, 0}, {8, 0, 0}, {8, 0, 4}, {0, 0, 4}});
  const auto beside = [&](double end) {
    BoxRuns others;
    others.add(std::vector<Aabb>{{{-1, -1, 0}, {3, 1, 4}}, {{3, -1, -1}, {end, 1, 5}}});
    return cover_upright(f, fit_plane(corners_of(f)), 0.5, others).size();
  };
  EXPECT_EQ(beside(8.5), 0u);  // together
  EXPECT_EQ(beside(7.5), 1u);
}

TEST(CoverUpright, LeavesOutThePartsOfAGableThatABoxHolds) {
  const Footprint f = solid_under({{0, 0, 0}, {8, 0, 0}, {8, 0, 8}, {0, 0, 4}});
  BoxRuns others;
  others.add(std::vector<Aabb>{{{-1, -1, 0}, {9, 1, 6}}});  // up to x = 4
  const auto boxes = cover_upright(f, fit_plane(corners_of(f)), 0.5, others);
  EXPECT_TRUE(any_holds(boxes, {4.1, 0, 6.04}));
  EXPECT_FALSE(any_holds(boxes, {3.9, 0, 5.9}));
}

TEST(CoverUpright, HoldsAllBelowAndKeepsTheSlack) {
  support::Random random(12);
  for (int k = 0; k < 150; ++k) {
    const double slack = random.uniform(0.1, 1);
    const double turn = random.uniform(0, 7);
    const double lean = k % 2 ? slack / 10 : 0;
    const auto at = [&](double along, double z) {
      const double aside = random.uniform(-lean, lean);
      return Vec3(500 + along * std::cos(turn) - aside * std::sin(turn),
                  along * std::sin(turn) + aside * std::cos(turn), z);
    };
    // A fan about the first corner: what it spans is below the ring's upper edges.
    const Footprint f = solid_under({at(0, 2), at(9, 2), at(9, random.uniform(5, 9)),
                                     at(5, random.uniform(9, 14)), at(0, random.uniform(5, 9))},
                                    2);
    const std::vector<Aabb> boxes = covered(f, slack);
    const oracle::SolidBelow solid(f);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = solid.point(random);
      EXPECT_TRUE(any_holds(boxes, p)) << "case " << k << ": " << p.transpose();
    }
    for (const Aabb& box : boxes) {
      for (int c = 0; c < 4; ++c) {
        const Vec3 corner(c % 2 ? box.max.x() : box.min.x(), c / 2 ? box.max.y() : box.min.y(),
                          box.max.z());
        EXPECT_LE(solid.distance(corner), slack + solid.coarseness()) << "case " << k;
      }
    }
  }
}

}  // namespace
}  // namespace geom
