#include "geom/map/geoid_grid.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom {
namespace {

template <class T, class Bits>
void append(std::string& out, T value) {
  const Bits bits = std::bit_cast<Bits>(value);
  for (int i = static_cast<int>(sizeof(T)) - 1; i >= 0; --i) {
    out += static_cast<char>(bits >> (8 * i) & 0xff);
  }
}

// Heights 10 + row + 20 * column, from 40 N 5 E in steps of a degree or `step`.
std::string gtx(float first = 10, double step = 1) {
  std::string out;
  for (const double head : {40.0, 5.0, step, step}) append<double, std::uint64_t>(out, head);
  for (const std::int32_t count : {3, 4}) append<std::int32_t, std::uint32_t>(out, count);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const float height =
          row + column == 0 ? first : 10.0F + static_cast<float>(row + 20 * column);
      append<float, std::uint32_t>(out, height);
    }
  }
  return out;
}

constexpr double kError = 1.2 * 16;  // m, of steps of a degree

GeoidGrid grid_of(const std::string& bytes) { return read_geoid_grid(support::Text(bytes), "g"); }

TEST(GeoidGrid, BoundsTheSlopesOverAnAreaWithItsError) {
  const GeoidGrid grid = grid_of(gtx());
  EXPECT_EQ(grid.columns, 4U);
  const auto range = grid.over({40.5, 41.5, 5.25, 6.5});
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->least, 10 + 0.5 + 20 * 0.25 - kError, 0.001);
  EXPECT_NEAR(range->most, 10 + 1.5 + 20 * 1.5 + kError, 0.001);
  EXPECT_LT(range->least, 15.5 - kError);
}

TEST(GeoidGrid, LongerStepsOfAGtxMayBeFurtherOff) {
  EXPECT_EQ(grid_of(gtx(10, 0.125)).error, 1.2);
  EXPECT_EQ(grid_of(gtx(10, 0.25)).error, 1.2);
  EXPECT_NEAR(grid_of(gtx(10, 0.5)).error, 4.8, 1e-12);
}

TEST(GeoidGrid, APartOfItSaysTheSameOverItsArea) {
  const GeoidGrid grid = grid_of(gtx());
  const GeoidArea area{40.5, 41.5, 5.25, 6.5};
  const GeoidGrid part = grid_of(gtx_over(grid, area));
  EXPECT_NEAR(part.over(area)->least, grid.over(area)->least, 1e-9);
  EXPECT_NEAR(part.over(area)->most, grid.over(area)->most, 1e-9);
  const GeoidArea place{41.25, 41.25, 6.125, 6.125};
  EXPECT_NEAR(part.over(place)->least, grid.over(place)->least, 1e-6);
  EXPECT_FALSE(part.over({40.5, 41.5, 5.25, 12}));
  EXPECT_THROW(gtx_over(grid, {39, 41, 5.25, 6.5}), InputError);
  GeoidGrid rough = grid;
  rough.error = kError + 1;
  EXPECT_THROW(gtx_over(rough, area), InputError) << "a .gtx does not say its error";
}

TEST(GeoidGrid, APartKeepsItsHoles) {
  const GeoidGrid grid = grid_of(gtx(-88.8888F));
  const GeoidGrid part = grid_of(gtx_over(grid, {40.5, 41.5, 6.25, 6.5}));
  EXPECT_FALSE(part.over({40.2, 40.8, 5.2, 5.8}));
}

TEST(GeoidGrid, KnowsNothingBeyondItsEdgesAndAtItsHoles) {
  const GeoidGrid grid = grid_of(gtx());
  EXPECT_FALSE(grid.over({39.9, 41, 5.25, 6.5}));
  EXPECT_FALSE(grid.over({41, 42.1, 5.25, 6.5}));
  EXPECT_FALSE(grid.over({41, 41.5, 4.9, 6.5}));
  EXPECT_FALSE(grid.over({41, 41.5, 7, 8.1}));
  EXPECT_TRUE(grid.over({40.001, 41.999, 5.001, 7.999}));
  EXPECT_FALSE(grid_of(gtx(-88.8888F)).over({40.2, 40.8, 5.2, 5.8}));
}

TEST(GeoidGrid, GoesAroundTheEarth) {
  std::string bytes =
      "P5\n# Geoid\n# Offset -10\n# Scale 0.01\n# MaxBilinearError 0.5\n4 3\n65535\n";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const int number = 1000 + 100 * column;  // 0, 1, 2, 3 m at 0, 90, 180, 270 E
      bytes += static_cast<char>(number >> 8);
      bytes += static_cast<char>(number & 0xff);
    }
  }
  const GeoidGrid grid = [&] {
    GeoidGrid out;
    EXPECT_THROW(read_geoid_grid(support::Text(bytes), "g"), InputError) << "steps of 90 degrees";
    return out;
  }();
  EXPECT_TRUE(grid.heights.empty());
  GeoidGrid around{
      .south = -1, .west = 0, .north_step = 1, .east_step = 10, .columns = 36, .rows = 3};
  for (int i = 0; i < 36 * 3; ++i) around.heights.push_back(static_cast<float>(i % 36));
  const auto range = around.over({-0.5, 0.5, -5, 5});
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->least, 0, 0.001);
  EXPECT_NEAR(range->most, 17.5, 0.001);
}

// The whole Earth in steps of ten degrees, all at 30 m where the scale is 0.01 m.
std::string pgm(const std::string& scale, const std::string& error) {
  std::string out =
      "P5\n# Offset 20\n# Scale " + scale + "\n# MaxBilinearError " + error + "\n36 19\n65535\n";
  for (int i = 0; i < 36 * 19; ++i) out += {1000 / 256, static_cast<char>(1000 % 256)};
  return out;
}

TEST(GeoidGrid, RefusesAScaleOfZeroAndAnErrorBelowIt) {
  EXPECT_NEAR(grid_of(pgm("0.01", "0.5")).over({1, 1, 1, 1})->least, 30 - 0.51, 0.001);
  EXPECT_THROW(grid_of(pgm("0", "0.5")), InputError);
  EXPECT_THROW(grid_of(pgm("0.01", "-5")), InputError);
}

TEST(GeoidGrid, RefusesWhatIsCutOrNone) {
  EXPECT_THROW(grid_of(gtx().substr(0, 80)), InputError);
  EXPECT_THROW(grid_of("P5\nno grid"), InputError);
  EXPECT_THROW(grid_of(std::string(88, 'x')), InputError);
}

}  // namespace
}  // namespace geom
