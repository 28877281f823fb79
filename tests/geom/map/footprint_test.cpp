#include "geom/map/footprint.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/import/city_json.h"

namespace geom {
namespace {

std::vector<Vec2> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

bool any_holds(const BoxTable& table, const Vec3& p) {
  for (const Aabb& box : table.boxes) {
    if (contains(box, p)) return true;
  }
  return false;
}

TEST(BoxesOf, LeaveOutAFloorThatTheRoofHolds) {
  const std::vector<Footprint> house = {{{square(0, 10), {}}, 0, 5, 1, false},
                                        {{square(0, 10), {}}, 0, 0, 1, true}};
  EXPECT_EQ(boxes_of(house, 0.5, {}).boxes.size(), 1u);
}

TEST(BoxesOf, KeepAFloorUnderAnOpenCourt) {
  const std::vector<Footprint> house = {{{square(0, 10), {square(3, 7)}}, 0, 5, 1, false},
                                        {{square(0, 10), {}}, 0, 0, 1, true}};
  const BoxTable table = boxes_of(house, 0.2, {});
  EXPECT_TRUE(any_holds(table, {5, 5, 0}));
  EXPECT_FALSE(any_holds(table, {5, 5, 1}));
}

CityJson city(const std::string& objects, const std::string& more = "") {
  std::istringstream in(R"({"type":"CityJSON","version":"2.0","vertices":[[0,0,0],[9,0,0],[9,9,4],)"
                        R"([50,0,0],[59,0,0],[59,9,7],[100,200,5]],"CityObjects":)" +
                        objects + more + "}");
  return read_city_json(in, "city");
}

TEST(CityJson, TakesAllGeometriesOfTheHighestLevel) {
  const CityJson both = city(R"({"b":{"type":"Building","geometry":[)"
                             R"({"type":"MultiSurface","lod":"1","boundaries":[[[0,1,5]]]},)"
                             R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]},)"
                             R"({"type":"MultiSurface","lod":"2","boundaries":[[[3,4,5]]]}]}})");
  ASSERT_EQ(both.footprints.size(), 2u);
  EXPECT_EQ(both.footprints[0].top, 4);
  EXPECT_EQ(both.footprints[1].top, 7);
  EXPECT_EQ(both.footprints[0].id, both.footprints[1].id);
}

constexpr const char* kTree =
    R"({"t":{"type":"SolitaryVegetationObject","geometry":[{"type":"GeometryInstance",)"
    R"("template":0,"boundaries":[6],"transformationMatrix":[2,0,0,1,0,2,0,0,0,0,3,0,0,0,0,1]}]}})";

TEST(CityJson, PlacesTemplates) {
  const CityJson tree = city(kTree, R"(,"geometry-templates":{"templates":[{"type":"MultiSurface",)"
                                    R"("lod":"2","boundaries":[[[0,1,2]]]}],"vertices-templates":)"
                                    R"([[0,0,0],[1,0,0],[1,1,2]]})");
  ASSERT_EQ(tree.footprints.size(), 1u);
  EXPECT_EQ(tree.footprints[0].bottom, 5);
  EXPECT_EQ(tree.footprints[0].top, 11);
  EXPECT_EQ(tree.footprints[0].polygon.outer[0], Vec2(101, 200));
  EXPECT_EQ(tree.footprints[0].polygon.outer[2], Vec2(103, 202));
}

TEST(CityJson, RefusesATemplateThatIsNotThere) { EXPECT_ANY_THROW(city(kTree)); }

}  // namespace
}  // namespace geom
