#include "gis/gml_geometry.h"

#include <gtest/gtest.h>

namespace geom::gis {
namespace {

TEST(GmlNumbers, AreWholePointsOfFiniteNumbers) {
  EXPECT_EQ(gml_numbers(" 1 2\n3.5e0 ", {})->size(), 3u);
  EXPECT_FALSE(gml_numbers("1 2", {}));
  EXPECT_FALSE(gml_numbers("1 2 inf", {}));
  EXPECT_FALSE(gml_numbers("1 2 x", {}));
  EXPECT_EQ(gml_numbers("", {})->size(), 0u);
  GmlNumbers form;
  form.between_numbers = ";";
  form.decimal = ',';
  EXPECT_EQ(gml_numbers("1,5;2;3", form)->at(0), 1.5);
}

TEST(GmlShapes, TakeEachPolygonOnce) {
  GmlShapes shapes;
  const auto all = shapes.add_shape("");
  const auto part = shapes.add_shape("p");
  shapes.add_polygon(part, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}});
  shapes.add_part(all, part);
  shapes.add_link(all, "p");
  EXPECT_EQ(shapes.surfaces_of(all).surfaces.size(), 1u);
  EXPECT_EQ(shapes.surfaces_of(all).lost, "");
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
  shift(0, 3) = 7;
  EXPECT_EQ(shapes.surfaces_of(all, shift).surfaces[0][0][1], geom::Vec3(8, 0, 0));
}

TEST(GmlShapes, SayWhichLinkIsLost) {
  GmlShapes shapes;
  const auto all = shapes.add_shape("");
  shapes.add_link(all, "nowhere");
  EXPECT_EQ(shapes.surfaces_of(all).lost, "nowhere");
  shapes.add_shape("twice");
  shapes.add_shape("twice");
  const auto other = shapes.add_shape("");
  shapes.add_link(other, "twice");
  EXPECT_EQ(shapes.surfaces_of(other).lost, "twice");
}

}  // namespace
}  // namespace geom::gis
