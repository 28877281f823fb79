#include "traj/mission/flown/fence_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/base/usage_error.h"

namespace traj {
namespace {

const geom::GeodeticOrigin kOrigin{47.4, 8.5, 400};

geom::BoxMapSpec spec() {
  geom::BoxMapSpec out;
  out.bounds = {{-100, -100, 0}, {100, 100, 50}};
  out.frame.origin = kOrigin;
  return out;
}

// A circle of 20 m around the origin.
GeodeticFence circle(bool inclusion) {
  return {.inclusion = inclusion, .centre = {47.4, 8.5, 0}, .radius = 20};
}

bool forbidden(const geom::BoxTable& table, const geom::Vec3& p) {
  return std::any_of(table.boxes.begin(), table.boxes.end(),
                     [&](const geom::Aabb& box) { return geom::distance(p, box) == 0; });
}

TEST(FenceBoxes, HoldAnExclusionFromTheBottomToTheTop) {
  const GeodeticFence fences[] = {circle(false)};
  const geom::BoxTable table = fence_boxes(fences, "f", spec());
  EXPECT_TRUE(forbidden(table, {0, 0, 0}));
  EXPECT_TRUE(forbidden(table, {14, 14, 50}));
  EXPECT_FALSE(forbidden(table, {16, 16, 25}));
  EXPECT_EQ(table.labels[table.label[0]], "fence");
}

TEST(FenceBoxes, HoldAllOutsideOfAnInclusionWithinTheBounds) {
  const GeodeticFence fences[] = {circle(true)};
  const geom::BoxTable table = fence_boxes(fences, "f", spec());
  EXPECT_FALSE(forbidden(table, {0, 0, 25}));
  EXPECT_TRUE(forbidden(table, {15, 15, 25}));
  EXPECT_TRUE(forbidden(table, {-100, 100, 0}));
  for (const geom::Aabb& box : table.boxes) {
    EXPECT_GE(box.min.x(), -100);
    EXPECT_LE(box.max.y(), 100);
  }
}

TEST(FenceBoxes, CountTheFences) {
  const GeodeticFence fences[] = {circle(false), circle(false)};
  const geom::BoxTable table = fence_boxes(fences, "f", spec());
  EXPECT_EQ(table.ids.front(), 0u);
  EXPECT_EQ(table.ids.back(), 1u);
}

TEST(FenceBoxes, NeedAMapWithAnOriginOnEarth) {
  geom::BoxMapSpec nowhere = spec();
  nowhere.frame.origin.reset();
  const GeodeticFence fences[] = {circle(false)};
  EXPECT_THROW(fence_boxes(fences, "f", nowhere), geom::UsageError);
}

}  // namespace
}  // namespace traj
