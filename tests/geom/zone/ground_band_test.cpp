#include "geom/zone/ground_band.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMapSpec spec() { return {.frame = {}, .bounds = {{0, 0, 0}, {200, 100, 400}}}; }

GroundModel slope(double error, double hole_at = -1) {
  GroundGridSpec grid{.corner = {0, 0}, .cell = 10, .columns = 20, .rows = 10, .error = error};
  std::vector<double> low;
  for (std::size_t k = 0; k < 200; ++k) {
    low.push_back(static_cast<double>(k) == hole_at ? std::nan("") : static_cast<double>(k % 20));
  }
  std::vector<double> high = low;
  for (double& z : high) z += 0.75;
  return {grid, low, high};
}

bool closed(const BoxTable& table, const Vec3& p) {
  for (const Aabb& box : table.boxes) {
    if (contains(box, p)) return true;
  }
  return false;
}

TEST(GroundBandBoxes, KeepAVehicleWithinTheBandOverAnyGroundOfTheModel) {
  const GroundModel ground = slope(0.5);
  const BoxTable boxes = ground_band_boxes({.low = 30, .high = 120}, ground, spec(), "g");
  support::Random random(11);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(random.uniform(0, 200), random.uniform(0, 100), random.uniform(0, 400));
    const double low = std::floor(p.x() / 10) - 0.5;  // of the true ground
    const double high = std::floor(p.x() / 10) + 1.25;
    const bool within = p.z() - high > 30 && p.z() - low < 120;
    if (!within) {
      ASSERT_TRUE(closed(boxes, p)) << "case " << i;
    }
    const bool well_within = p.z() - high > 33 && p.z() - low < 117;
    if (well_within) {
      ASSERT_FALSE(closed(boxes, p)) << "case " << i;
    }
  }
}

TEST(GroundBandBoxes, AreFewWhereTheStepIsLarge) {
  const GroundModel ground = slope(0);
  const std::size_t fine =
      ground_band_boxes({.high = 120, .step = 1}, ground, spec(), "g").boxes.size();
  const std::size_t coarse =
      ground_band_boxes({.high = 120, .step = 40}, ground, spec(), "g").boxes.size();
  EXPECT_GT(fine, 10U);
  EXPECT_EQ(coarse, 1U);
}

TEST(GroundBandBoxes, RefuseAHoleUnlessItIsClosed) {
  const GroundModel ground = slope(0, 42);
  EXPECT_THROW(ground_band_boxes({.high = 120}, ground, spec(), "g"), InputError);
  const BoxTable boxes =
      ground_band_boxes({.high = 120, .close_unknown = true}, ground, spec(), "g");
  EXPECT_TRUE(closed(boxes, {25, 25, 50}));
  EXPECT_FALSE(closed(boxes, {35, 25, 50}));
}

TEST(GroundBandBoxes, RefuseAModelThatEndsWithinTheBounds) {
  BoxMapSpec wide = spec();
  wide.bounds.max.x() = 201;
  EXPECT_THROW(ground_band_boxes({.high = 120}, slope(0), wide, "g"), InputError);
}

TEST(RequireSameZero, RefusesGroundThatIsAboveAllThatStands) {
  BoxTable table;
  table.add({{1, 1, 0}, {2, 2, 30}}, 0);
  const BoxMap town(spec(), table);
  EXPECT_NO_THROW(require_same_zero(GroundModel::flat(0), town, "g"));
  EXPECT_NO_THROW(require_same_zero(slope(0), town, "g"));
  EXPECT_THROW(require_same_zero(GroundModel::flat(31), town, "g"), InputError);
  EXPECT_THROW(require_same_zero(GroundModel::flat(540), town, "g"), InputError);
  EXPECT_THROW(require_same_zero(GroundModel::flat(-1), town, "g"), InputError);
}

}  // namespace
}  // namespace geom
