#include "import/plan_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geom {
namespace {

CitySurface rectangle(double west, double south, double east, double north, double z = 0) {
  return {{{west, south, z}, {east, south, z}, {east, north, z}, {west, north, z}}};
}

// A polygon of 64 corners, turned.
CitySurface circle(double x, double y, double radius) {
  CitySurface out(1);
  for (int i = 0; i < 64; ++i) {
    const double turn = 0.1 + i * std::numbers::pi / 32;
    out[0].push_back({x + radius * std::cos(turn), y + radius * std::sin(turn), 0});
  }
  return out;
}

bool gap(const CitySurface& plan, const std::vector<CitySurface>& parts) {
  CitySurfaces list;
  for (const CitySurface& part : parts) list.push_back(&part);
  return has_gap({&plan}, list);
}

const CitySurface kPlan = rectangle(0, 0, 100, 100);

TEST(HasGap, IsFalseWherePartsStandOnAllOfThePlan) {
  EXPECT_FALSE(gap(kPlan, {kPlan}));
  EXPECT_FALSE(gap(kPlan, {rectangle(0, 0, 50, 100, 7), rectangle(50, 0, 100, 100, 20)}));
  EXPECT_FALSE(gap(kPlan, {rectangle(-5, -5, 105, 60), rectangle(-5, 60, 105, 105)}));
  EXPECT_FALSE(has_gap({}, {}));
}

// Stacked parts are large together, and stand on the same place.
TEST(HasGap, IsTrueWherePartsStandOnOneAnother) {
  EXPECT_TRUE(gap(kPlan, {rectangle(0, 0, 80, 100), rectangle(0, 0, 80, 100, 10),
                          rectangle(0, 0, 80, 100, 20), rectangle(0, 0, 80, 100, 30)}));
  EXPECT_TRUE(gap(kPlan, {rectangle(0, 0, 91, 100)}));
  EXPECT_TRUE(gap(kPlan, {}));
}

TEST(HasGap, PassesOverSlivers) {
  EXPECT_FALSE(gap(kPlan, {rectangle(0.3, 0.3, 99.7, 99.7)}));
  EXPECT_TRUE(gap(kPlan, {rectangle(0, 0, 98.9, 100)}));
  EXPECT_TRUE(gap(kPlan, {rectangle(0, 1.1, 100, 100)}));
}

TEST(HasGap, MissesNoCircle) {
  for (int i = 0; i < 200; ++i) {
    CitySurface part = kPlan;
    const double shift = 0.013 * i;
    part.push_back(circle(31 + shift, 47 - 0.7 * shift, 0.51 * kWidestSliver)[0]);
    EXPECT_TRUE(gap(kPlan, {part})) << i;
  }
}

TEST(HasGap, KnowsHoles) {
  CitySurface ring = kPlan;
  ring.push_back(rectangle(40, 40, 60, 60)[0]);
  EXPECT_TRUE(gap(kPlan, {ring}));
  EXPECT_FALSE(gap(ring, {ring}));
  EXPECT_FALSE(gap(kPlan, {ring, rectangle(39, 39, 61, 61)}));
}

TEST(HasGap, IsFinerForASmallPlan) {
  EXPECT_TRUE(gap(rectangle(0, 0, 3, 3), {rectangle(0, 0, 2.5, 3)}));
  EXPECT_TRUE(gap(rectangle(0, 0, 3e-5, 3e-5), {rectangle(0, 0, 2.5e-5, 3e-5)}));
  EXPECT_FALSE(gap(rectangle(0, 0, 3, 3), {rectangle(0, 0, 2.9, 3)}));
}

TEST(HasGap, TakesWallsForNothing) {
  EXPECT_TRUE(gap(kPlan, {{{{0, 0, 0}, {100, 0, 0}, {100, 0, 9}, {0, 0, 9}}}}));
}

TEST(HasGap, IsTrueOfWhatIsLongerThanAnyBuilding) {
  const CitySurface long_one = rectangle(0, 0, 1e6, 9);
  EXPECT_TRUE(gap(long_one, {long_one}));
}

}  // namespace
}  // namespace geom
