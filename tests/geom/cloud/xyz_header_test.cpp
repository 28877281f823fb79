#include "cloud/xyz_header.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

using Names = std::vector<std::string_view>;
using Axes3 = std::array<std::size_t, 3>;

Axes3 columns(const Names& names) { return xyz_columns(names, {"t", 1}).of_axis; }
bool refused(const Names& names) {
  return !support::refusal_of([&] { columns(names); }).empty();
}

TEST(XyzColumns, KnowTheNamesThatProgramsWrite) {
  EXPECT_EQ(columns({"X", "Y", "Z"}), (Axes3{0, 1, 2}));
  EXPECT_EQ(columns({"id", "Northing", "Easting", "Elevation [m]"}), (Axes3{2, 1, 3}));
  EXPECT_EQ(columns({"point_x", "y_coordinate", "alt", "nx", "ny", "nz"}), (Axes3{0, 1, 2}));
  EXPECT_EQ(columns({"N", "E", "H"}), (Axes3{1, 0, 2}));
  EXPECT_EQ(columns({"Y_m", "X_m", "Z_m"}), (Axes3{1, 0, 2}));
}

TEST(XyzColumns, GoByTheLettersWhereAllThreeAreThere) {
  EXPECT_EQ(columns({"easting", "x", "y", "z", "height"}), (Axes3{1, 2, 3}));
  EXPECT_TRUE(refused({"easting", "x", "y", "height"}));
}

TEST(XyzColumns, RefuseWhatIsMissingTwiceOrNoMetre) {
  EXPECT_TRUE(refused({"x", "y"}));
  EXPECT_TRUE(refused({"x", "y", "z", "z"}));
  EXPECT_TRUE(refused({"lon", "lat", "z"}));
  EXPECT_TRUE(refused({"x (deg)", "y (deg)", "z"}));
  EXPECT_TRUE(refused({"x_ft", "y_ft", "z_ft"}));
  EXPECT_TRUE(refused({"n", "e", "d"}));
}

TEST(NameAllAxes, IsWhatACommentMayBeAHeaderBy) {
  EXPECT_TRUE(name_all_axes(Names{"scan", "of", "x", "y", "z"}));
  EXPECT_TRUE(name_all_axes(Names{"lat", "lon", "z"}));
  EXPECT_FALSE(name_all_axes(Names{"x", "y"}));
  EXPECT_FALSE(name_all_axes(Names{"x", "1", "y", "2", "z", "3"}));
}

TEST(FieldsOf, AreEmptyBetweenTwoCommasAndNotBetweenTwoBlanks) {
  std::vector<std::string_view> fields;
  fields_of(',', "a, ,b,", fields);
  EXPECT_EQ(fields, (Names{"a", "", "b", ""}));
  fields_of(' ', "a   b", fields);
  EXPECT_EQ(fields, (Names{"a", "b"}));
}

TEST(SeparatorOf, StandsBehindTheFirstNumber) {
  EXPECT_EQ(separator_of("1 ; 5,2"), ';');
  EXPECT_EQ(separator_of("1,5 2"), ',');
  EXPECT_EQ(separator_of("1 \t5 2"), '\t');
  EXPECT_EQ(separator_of("1 2 3 old, red"), ' ');
  EXPECT_EQ(separator_of("Point 7,1,2,3"), ',');
  EXPECT_EQ(separator_of("X Y Z"), ' ');
}

}  // namespace
}  // namespace geom
