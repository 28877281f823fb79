#include "geom/collision/height_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace geom {
namespace {

// Towers and boxes that hang in the air, over 60 m by 40 m.
BoxMap town(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> x(0, 60), y(0, 40), size(1, 8), z(0, 50);
  BoxTable table;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Vec3 low(x(random), y(random), i % 3 == 0 ? z(random) : 0);
    table.add({low, low + Vec3(size(random), size(random), 3 * size(random))}, i);
  }
  return BoxMap({.bounds = {{0, 0, 0}, {60, 40, 50}}, .bounds_from = "source"}, table);
}

class HeightGrid : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const CollisionScene scene_{town(GetParam()), Vehicle{.name = "v", .half = {0.4, 0.3, 0.2}}, 0.5};
  const CellGrid2 grid_{.corner = {0, 0}, .cell = 2.5, .columns = 24, .rows = 16};
};

TEST_P(HeightGrid, HeightsAreFreeAnywhereInTheCell) {
  const FreeHeights heights = free_heights(scene_, grid_);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::size_t free = 0;
  for (std::size_t i = 0; i < heights.highest.size(); ++i) {
    if (std::isnan(heights.highest[i])) continue;
    ++free;
    const Aabb cell = grid_.box(i % grid_.columns, i / grid_.columns);
    for (int k = 0; k < 200; ++k) {
      // Corners and ends among them.
      const auto within = [&](double low, double high) {
        const double s = share(random);
        return s < 0.2 ? low : s > 0.8 ? high : low + (high - low) * s;
      };
      const Vec3 p(within(cell.min.x(), cell.max.x()), within(cell.min.y(), cell.max.y()),
                   within(heights.lowest[i], heights.highest[i]));
      ASSERT_TRUE(scene_.free(p)) << p.transpose();
    }
  }
  EXPECT_GT(free, 100u);
}

TEST_P(HeightGrid, NoHigherStretchIsLeftOut) {
  const FreeHeights heights = free_heights(scene_, grid_);
  const double top = scene_.free_bounds()->max.z();
  for (std::size_t i = 0; i < heights.highest.size(); ++i) {
    Aabb cell = grid_.box(i % grid_.columns, i / grid_.columns);
    const bool inside = scene_.inside_bounds({cell.min.x(), cell.min.y(), top}) &&
                        scene_.inside_bounds({cell.max.x(), cell.max.y(), top});
    if (!inside) continue;
    const double from = std::isnan(heights.highest[i]) ? 0 : heights.highest[i];
    for (double z = top; z > from + 1e-6; z -= 0.25) {
      cell.min.z() = cell.max.z() = z;
      EXPECT_FALSE(scene_.boxes_meeting(cell).empty()) << i << " at " << z;
    }
  }
}

TEST_P(HeightGrid, DistancesAreNeverMoreThanAnywhereInTheCell) {
  const double z = 12;
  const std::vector<double> distances = distances_at(scene_, grid_, z);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isnan(distances[i])) continue;
    const Aabb cell = grid_.box(i % grid_.columns, i / grid_.columns);
    double least = 1e9;
    for (int k = 0; k < 300; ++k) {
      const double s = k < 4 ? k % 2 : share(random);
      const double t = k < 4 ? k / 2 : share(random);
      const Vec3 p(cell.min.x() + s * grid_.cell, cell.min.y() + t * grid_.cell, z);
      least = std::min(least, scene_.nearest(p, 1e9)->distance);
    }
    EXPECT_LE(distances[i], least) << i;
    EXPECT_GE(distances[i], least - 0.6) << i;  // what 300 places leave between them
  }
}

TEST_P(HeightGrid, CellsBeyondTheBoundsHaveNoNumber) {
  const CellGrid2 outside{.corner = {-5, -5}, .cell = 2.5, .columns = 1, .rows = 1};
  EXPECT_TRUE(std::isnan(free_heights(scene_, outside).highest[0]));
  EXPECT_TRUE(std::isnan(distances_at(scene_, outside, 12)[0]));
  EXPECT_TRUE(std::isnan(distances_at(scene_, grid_, 60)[100]));
}

INSTANTIATE_TEST_SUITE_P(Seeds, HeightGrid, ::testing::Values(1u, 2u, 3u));

}  // namespace
}  // namespace geom
