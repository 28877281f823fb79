#include "map/held_within.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace geom
