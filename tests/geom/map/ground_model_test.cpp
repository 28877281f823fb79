#include "geom/map/ground_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "geom/base/error.h"
#include "support/temporary_folder.h"

namespace geom {
namespace {

constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

GroundModel hill(double error = 0) {
  GroundGridSpec spec{.corner = {-10, 0}, .cell = 10, .columns = 3, .rows = 2, .error = error};
  spec.source = "hill.tif";
  spec.hash = "sha256:0";
  return {spec, {1, 2, 3, 4, 5, kHole}, {2, 4, 6, 8, 9, kHole}};
}

TEST(GroundModel, GivesTheRangeOfTheCellsThatHoldARegion) {
  const GroundRange one = hill().range({{-10, 0}, {0, 10}});
  EXPECT_TRUE(one.all_known);
  EXPECT_EQ(one.low, 1);
  EXPECT_EQ(one.high, 2);
  const GroundRange four = hill().range({{-10, 0}, {0.1, 10.1}});
  EXPECT_EQ(four.low, 1);
  EXPECT_EQ(four.high, 9);
  EXPECT_EQ(hill().range({{-5, 5}, {-5, 5}}).high, 2) << "a point";
  EXPECT_EQ(hill().range({{0, 5}, {0, 5}}).high, 4) << "a point of a face";
}

TEST(GroundModel, AddsItsError) {
  const GroundRange one = hill(0.5).range({{-10, 0}, {0, 10}});
  EXPECT_EQ(one.low, 0.5);
  EXPECT_EQ(one.high, 2.5);
}

TEST(GroundModel, KnowsNothingInHolesAndBeyondItsGrid) {
  EXPECT_FALSE(hill().range({{15, 15}, {16, 16}}).any_known);
  const GroundRange partly = hill().range({{5, 15}, {16, 16}});
  EXPECT_TRUE(partly.any_known);
  EXPECT_FALSE(partly.all_known);
  EXPECT_FALSE(hill().range({{-11, 5}, {-5, 5}}).all_known);
  EXPECT_FALSE(hill().range({{500, 5}, {501, 5}}).any_known);
}

TEST(GroundModel, CutsARegionAlongFacesUntilCellsAreLeft) {
  const auto parts = hill().cut({{-10, 0}, {20, 20}});
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->first.max.x(), parts->second.min.x());
  EXPECT_TRUE(parts->first.max.x() == 0 || parts->first.max.x() == 10);
  EXPECT_FALSE(hill().cut({{-10, 0}, {0, 10}}));
  EXPECT_FALSE(GroundModel::flat(3).cut({{-10, 0}, {20, 20}}));
}

TEST(GroundModel, IsWrittenAndReadBack) {
  const support::TemporaryFolder folder;
  const std::string path = folder.path() / "hill.ground";
  GroundGridSpec spec = hill(0.25).spec();
  spec.frame.origin = GeodeticOrigin{47, 8, 400};
  const GroundModel ground(spec, {1, 2, 3, 4, 5, kHole}, {2, 4, 6, 8, 9, kHole});
  {
    std::ofstream file(path, std::ios::binary);
    write_ground(file, ground);
  }
  const GroundModel back = read_ground(path);
  EXPECT_EQ(back.spec().frame, spec.frame);
  EXPECT_EQ(back.spec().error, 0.25);
  EXPECT_EQ(back.spec().corner, spec.corner);
  EXPECT_EQ(back.spec().source, "hill.tif");
  EXPECT_EQ(back.range({{-10, 0}, {0, 10}}).high, 2.25);
  EXPECT_TRUE(std::isnan(back.highs()[5]));
}

TEST(GroundModel, RefusesTheMapOfAnotherFrame) {
  EXPECT_NO_THROW(require_same_frame(hill(), Frame{}, "city.ground"));
  Frame other;
  other.origin = GeodeticOrigin{47, 8, 0};
  EXPECT_THROW(require_same_frame(hill(), other, "city.ground"), InputError);
  EXPECT_NO_THROW(require_same_frame(GroundModel::flat(3), other, "city.ground"));
}

}  // namespace
}  // namespace geom
