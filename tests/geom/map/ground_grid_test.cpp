#include "geom/map/ground_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random_city.h"

namespace geom {
namespace {

TEST(GroundGrid, KnowsTheLastCellsThatItTakes) {
  const double cell = 1e8 / (0x1p31 - 3);
  for (const double sign : {1.0, -1.0}) {
    const double last = sign * (0x1p31 - 4.5) * cell;
    GroundGrid ground({cell, 0.1, 0.3});
    ground.add({last, last, 1});
    ground.finish();
    EXPECT_TRUE(ground.is_ground({last, last, 1.2}));
    EXPECT_FALSE(ground.is_ground({last, last, 1.5}));
  }
}

TEST(GroundGrid, TellsAHouseOnASlopeFromTheSlope) {
  GroundGrid ground({2, 1, 0.3});
  std::vector<Vec3> slope;
  std::vector<Vec3> house;
  support::Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(random.uniform(0, 60), random.uniform(0, 60), 0);
    const bool in_house = p.x() > 20 && p.x() < 35 && p.y() > 20 && p.y() < 35;
    (in_house ? house : slope).push_back({p.x(), p.y(), 0.4 * p.x() + (in_house ? 8 : 0)});
  }
  for (const auto& points : {slope, house}) {
    for (const Vec3& p : points) ground.add(p);
  }
  ground.finish();
  const auto counted = [&](const std::vector<Vec3>& points) {
    return std::count_if(points.begin(), points.end(),
                         [&](const Vec3& p) { return ground.is_ground(p); });
  };
  EXPECT_GT(counted(slope), 0.95 * static_cast<double>(slope.size()));
  EXPECT_LT(counted(house), 0.15 * static_cast<double>(house.size()));  // the eaves, upslope
}

// Four returns a square metre of what `height` says.
template <class Height>
std::vector<Vec3> scan(double side, std::uint64_t seed, const Height& height) {
  support::Random random(seed);
  std::vector<Vec3> out;
  for (int i = 0; i < static_cast<int>(4 * side * side); ++i) {
    const double x = random.uniform(0, side);
    const double y = random.uniform(0, side);
    out.push_back({x, y, height(x, y) + random.uniform(0, 0.05)});
  }
  return out;
}

GroundGrid grid_of(const std::vector<Vec3>& points, const GroundSpec& spec) {
  GroundGrid ground(spec);
  for (const Vec3& p : points) ground.add(p);
  ground.finish();
  return ground;
}

template <class Which>
double share_of_ground(const GroundGrid& ground, const std::vector<Vec3>& points,
                       const Which& which) {
  double all = 0;
  double found = 0;
  for (const Vec3& p : points) {
    if (!which(p)) continue;
    ++all;
    found += ground.is_ground(p);
  }
  return found / all;
}

// A roof that the slope alone takes for ground: 8 m high, and 200 m wide.
TEST(GroundGrid, TheMiddleOfAWideRoofIsNoGround) {
  const auto on_roof = [](double x, double y) { return x > 50 && x < 250 && y > 50 && y < 250; };
  const auto points = scan(300, 3, [&](double x, double y) { return on_roof(x, y) ? 8 : 0; });
  for (const double slope : {0.1, 0.5, 1.0}) {
    const GroundGrid ground = grid_of(points, {2, slope, 0.3});
    EXPECT_EQ(share_of_ground(ground, points, [](const Vec3& p) { return p.z() > 7; }), 0) << slope;
    EXPECT_GT(share_of_ground(ground, points, [](const Vec3& p) { return p.z() < 1; }), 0.95)
        << slope;
  }
}

// Wider than seeds look, with or without a wall around it.
TEST(GroundGrid, ARoofThatIsTheLowestFarAroundIsToldByItsEdge) {
  for (const bool parapet : {false, true}) {
    const auto height = [&](double x, double y) {
      const double inside = std::min({x - 10, 210 - x, y - 10, 210 - y});
      if (inside < 0) return 0.0;
      return parapet && inside < 2.5 ? 11.0 : 8.0;
    };
    const auto points = scan(220, 4, height);
    const GroundGrid ground = grid_of(points, {2, 0.5, 0.3, 0.3, 20});
    EXPECT_EQ(share_of_ground(ground, points, [](const Vec3& p) { return p.z() > 7; }), 0);
  }
}

// Between walls, out of reach: it may be a court or the roof of what the walls stand on.
TEST(GroundGrid, WhatNoSeedReachesIsNoGround) {
  const auto height = [](double x, double y) {
    const double inside = std::min({x - 30, 90 - x, y - 30, 90 - y});
    return inside < 0 ? 0.0 : inside < 10 ? 12.0 : 3.0;
  };
  const auto points = scan(120, 5, height);
  const GroundGrid ground = grid_of(points, {2, 1, 0.3});
  EXPECT_EQ(share_of_ground(ground, points, [](const Vec3& p) { return p.z() > 2; }), 0);
}

TEST(GroundGrid, AReturnDeepBelowTakesNoMoreThanItsSurroundings) {
  auto points = scan(200, 6, [](double, double) { return 10; });
  points.push_back({100, 100, -40});
  const GroundGrid ground = grid_of(points, {2, 1, 0.3});
  const auto far = [](const Vec3& p) {
    return (p.head<2>() - Vec3(100, 100, 0).head<2>()).norm() > 60;
  };
  EXPECT_GT(share_of_ground(ground, points, far), 0.99);
}

TEST(GroundGrid, DoesNotDependOnTheOrderOfThePoints) {
  const auto hills = [](double x, double y) { return 3 * std::sin(x / 20) + (y > 90 ? 7 : 0); };
  auto points = scan(100, 7, hills);
  const GroundGrid one = grid_of(points, {});
  std::reverse(points.begin(), points.end());
  const GroundGrid other = grid_of(points, {});
  for (const Vec3& p : points) ASSERT_EQ(one.is_ground(p), other.is_ground(p));
}

TEST(GroundGrid, WithoutPointsThereIsNone) {
  GroundGrid ground({});
  ground.finish();
  EXPECT_FALSE(ground.is_ground({0, 0, 0}));
}

}  // namespace
}  // namespace geom
