#include "map/cover_slope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solid_oracle.h"

namespace geom {
namespace {

using oracle::any_holds;
using oracle::solid_under;

std::vector<Aabb> covered(const Footprint& f, double slack, double margin = 0) {
  return cover_slope(f, fit_plane(corners_of(f)), slack, margin);
}

TEST(CoverSlope, FollowsARoofInStripes) {
  const Footprint roof = solid_under({{0, 0, 3}, {12, 0, 3}, {12, 5, 8}, {0, 5, 8}});
  const std::vector<Aabb> boxes = covered(roof, 0.5);
  EXPECT_LT(boxes.size(), 25u);
  EXPECT_TRUE(any_holds(boxes, {6, 2.5, 5.5}));
  EXPECT_TRUE(any_holds(boxes, {6, 0, 3}));
  EXPECT_FALSE(any_holds(boxes, {6, 1, 4.8}));
}

TEST(CoverSlope, TakesASteepFacetInFewSteps) {
  EXPECT_LT(covered(solid_under({{0, 0, 0}, {4, 0, 0}, {4, 1, 30}, {0, 1, 30}}), 0.5).size(), 10u);
}

TEST(CoverSlope, KeepsAHoleOpen) {
  Footprint f = solid_under({{0, 0, 2}, {20, 0, 2}, {20, 20, 12}, {0, 20, 12}});
  f.polygon.holes = {{{8, 8}, {12, 8}, {12, 12}, {8, 12}}};
  f.heights.insert(f.heights.end(), {6, 6, 8, 8});
  const std::vector<Aabb> boxes = covered(f, 0.5);
  EXPECT_FALSE(any_holds(boxes, {10, 10, 1}));
  EXPECT_TRUE(any_holds(boxes, {10, 7.9, 5.9}));
}

// A ring of thousands of corners is not cut into convex parts: its rectangles are cut.
TEST(CoverSlope, CoversRingsOfAnyNumberOfCorners) {
  std::vector<Vec3> ring;
  for (int i = 0; i < 2500; ++i) {
    const double angle = 2 * M_PI * i / 2500;
    const Vec2 p(20 * std::cos(angle), 20 * std::sin(angle));
    ring.push_back({p.x(), p.y(), 30 + 0.3 * p.x() + 0.2 * p.y()});
  }
  const Footprint f = solid_under(ring);
  const std::vector<Aabb> boxes = covered(f, 0.5);
  const oracle::SolidBelow solid(f);
  support::Random random(3);
  for (int i = 0; i < 3000; ++i) EXPECT_TRUE(any_holds(boxes, solid.point(random)));
  for (const Aabb& box : boxes) {
    const Vec2 at = 0.5 * (box.min + box.max).head<2>();
    EXPECT_LE(box.max.z(), 30 + 0.3 * at.x() + 0.2 * at.y() + 0.9);
  }
}

TEST(CoverSlope, HoldsAllBelowAndKeepsTheSlack) {
  support::Random random(11);
  for (int k = 0; k < 120; ++k) {
    const double slack = random.uniform(0.1, 1);
    const Vec2 gradient(random.uniform(-1, 1), random.uniform(-1, 1));
    const double steep = k % 4 == 0 ? 20 : 1;
    const double size = k % 4 == 0 ? 1.5 : 8;
    std::vector<Vec3> ring;
    const int n = 3 + random.below(5);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * M_PI * (i + random.uniform(0, 0.9)) / n;
      const Vec2 p(size * std::cos(angle) + 100, size * std::sin(angle) - 50);
      const double noise = k % 3 == 0 ? random.uniform(-0.01, 0.01) : 0;
      ring.push_back({p.x(), p.y(), 60 + steep * gradient.dot(p - Vec2(100, -50)) + noise});
    }
    const Footprint f = solid_under(ring, 10);
    const PlaneFit plane = fit_plane(corners_of(f));
    if (is_upright(plane, slack)) continue;
    const std::vector<Aabb> boxes = covered(f, slack, k % 2 ? slack / 50 : 0);
    const oracle::SolidBelow solid(f);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = solid.point(random);
      EXPECT_TRUE(any_holds(boxes, p)) << "case " << k << ": " << p.transpose();
    }
    const double allowed =
        slack + solid.coarseness() + std::max(0.0, 2 * plane.residual - slack / 2);
    for (std::size_t i = 0; i < boxes.size(); i += 1 + boxes.size() / 12) {
      for (int c = 0; c < 4; ++c) {
        const Vec3 corner(c % 2 ? boxes[i].max.x() : boxes[i].min.x(),
                          c / 2 ? boxes[i].max.y() : boxes[i].min.y(), boxes[i].max.z());
        EXPECT_LE(solid.distance(corner), allowed) << "case " << k << ": " << corner.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace geom
