#include "map/held_within.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/random.h"

namespace geom {
namespace {

Footprint square(double side, double top) {
  Footprint f;
  f.polygon.outer = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  f.top = top;
  return f;
}

bool held(const Footprint& f, const std::vector<Aabb>& boxes) { return HeldWithin()(f, boxes); }

TEST(HeldWithin, IsHeldByOneBoxThatIsAsHigh) {
  EXPECT_TRUE(held(square(4, 3), {{{0, 0, 0}, {4, 4, 3}}}));
  EXPECT_FALSE(held(square(4, 3), {{{0, 0, 0}, {4, 4, 2.9}}}));
  EXPECT_FALSE(held(square(4, 3), {{{0, 0, 0.1}, {4, 4, 3}}}));
  EXPECT_FALSE(held(square(4, 3), {{{0, 0, 0}, {4, 3.9, 3}}}));
  EXPECT_FALSE(held(square(4, 3), {}));
}

TEST(HeldWithin, IsHeldByBoxesThatTouch) {
  const Aabb left{{-1, -1, -1}, {2, 5, 3}};
  EXPECT_TRUE(held(square(4, 3), {left, {{2, -1, 0}, {5, 5, 9}}}));
  EXPECT_FALSE(held(square(4, 3), {left, {{2.1, -1, 0}, {5, 5, 9}}}));
}

TEST(HeldWithin, IsNotHeldWhereItsMiddleIsFree) {
  std::vector<Aabb> frame = {{{0, 0, 0}, {4, 1, 3}},
                             {{0, 3, 0}, {4, 4, 3}},
                             {{0, 0, 0}, {1, 4, 3}},
                             {{3, 0, 0}, {4, 4, 3}}};
  EXPECT_FALSE(held(square(4, 3), frame));
  Footprint yard = square(4, 3);
  yard.polygon.holes = {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  EXPECT_TRUE(held(yard, frame));
  frame.push_back({{1, 1, 0}, {3, 3, 3}});
  EXPECT_TRUE(held(square(4, 3), frame));
}

TEST(HeldWithin, OfManyBoxesOneMustHoldItAlone) {
  std::vector<Aabb> strips;
  for (int i = 0; i < 1001; ++i) strips.push_back({{0.01 * i, 0, 0}, {0.01 * (i + 1), 10, 3}});
  EXPECT_FALSE(held(square(10, 3), strips));
  strips.push_back({{0, 0, 0}, {10, 10, 3}});
  EXPECT_TRUE(held(square(10, 3), strips));
  strips.pop_back();
  strips.erase(strips.begin());
  EXPECT_FALSE(held(square(10, 3), strips));  // by a gap
  strips.push_back({{0, 0, 0}, {0.01, 10, 3}});
  strips.erase(strips.begin());
  strips.push_back({{0.01, 0, 0}, {0.03, 10, 3}});
  strips.erase(strips.begin());
  EXPECT_TRUE(held(square(10, 3), strips));  // by 1,000 of them
}

// Corners at sixteenths of a unit, so that some reach into a cell without a box by little of an
// edge.
Footprint random_triangle(SplitMix64& random) {
  Footprint f;
  f.top = 1;
  while (f.polygon.outer.size() < 3) {
    f.polygon.outer.push_back({random.whole(0, 64) / 16.0, random.whole(0, 64) / 16.0});
  }
  return f;
}

// Most cells of a grid of 4 x 4.
std::vector<Aabb> random_cells(SplitMix64& random) {
  std::vector<Aabb> cells;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      if (random.chance(0.85)) cells.push_back({Vec3(x, y, 0), Vec3(x + 1, y + 1, 1)});
    }
  }
  return cells;
}

// Whether a point of the triangle, of a fine net with all corners in it, is in none of the boxes.
bool has_free_point(const std::vector<Vec2>& t, const std::vector<Aabb>& boxes) {
  constexpr int kNet = 48;
  for (int i = 0; i <= kNet; ++i) {
    for (int j = 0; i + j <= kNet; ++j) {
      const Vec2 p = (i * t[0] + j * t[1] + (kNet - i - j) * t[2]) / kNet;
      const bool is_held = std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& box) {
        return (p.array() >= box.min.head<2>().array() - 1e-9).all() &&
               (p.array() <= box.max.head<2>().array() + 1e-9).all();
      });
      if (!is_held) return true;
    }
  }
  return false;
}

TEST(HeldWithin, IsNeverHeldWhereAPointOfItIsFree) {
  SplitMix64 random(11);
  int held_ones = 0;
  for (int i = 0; i < 20000; ++i) {
    const Footprint f = random_triangle(random);
    const std::vector<Aabb> cells = random_cells(random);
    if (!held(f, cells)) continue;
    ++held_ones;
    ASSERT_FALSE(has_free_point(f.polygon.outer, cells)) << i;
  }
  EXPECT_GT(held_ones, 1000);
}

// The floor of the wide part lies in a flat box, with nothing below it and nothing above.
TEST(HeldWithin, IsNotHeldAboveAFlatBox) {
  Footprint f;
  f.polygon.outer = {{0, 0}, {1, 0}, {1, 1}, {4, 1}, {4, 3}, {0, 3}};
  f.top = 1;
  const std::vector<Aabb> walls = {{Vec3(0, 0, 0), Vec3(1, 1, 1)},
                                   {Vec3(0, 1, 0), Vec3(1, 3, 1)},
                                   {Vec3(1, 1, 0), Vec3(4, 1, 1)},
                                   {Vec3(1, 3, 0), Vec3(4, 3, 1)},
                                   {Vec3(4, 1, 0), Vec3(4, 3, 1)}};
  EXPECT_FALSE(held(f, walls));
  std::vector<Aabb> filled = walls;
  filled.push_back({Vec3(1, 1, 0), Vec3(4, 3, 1)});
  EXPECT_TRUE(held(f, filled));
}

// Rows of boxes as cover() makes them, which end where others begin or a hair above, some left out.
std::vector<Aabb> random_rows(SplitMix64& random) {
  std::vector<Aabb> boxes;
  for (double y = 0; y < 4;) {
    const double next = std::min(4.0, y + random.whole(1, 16) / 16.0);
    for (double x = 0; x < 4;) {
      const double end = std::min(4.0, x + random.whole(8, 48) / 16.0);
      const double over = random.chance(0.5) ? 1e-9 : 0;
      if (random.chance(0.92)) {
        boxes.push_back({Vec3(x - over, y - over, 0), Vec3(end + over, next + over, 1)});
      }
      x = end;
    }
    y = next;
  }
  return boxes;
}

TEST(HeldWithin, IsNeverHeldByRowsWhereAPointOfItIsFree) {
  SplitMix64 random(12);
  int held_ones = 0;
  for (int i = 0; i < 20000; ++i) {
    const Footprint f = random_triangle(random);
    const std::vector<Aabb> rows = random_rows(random);
    if (!held(f, rows)) continue;
    ++held_ones;
    ASSERT_FALSE(has_free_point(f.polygon.outer, rows)) << i;
  }
  EXPECT_GT(held_ones, 1000);
}

}  // namespace
}  // namespace geom
