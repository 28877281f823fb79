#include "import/city_types.h"

#include <gtest/gtest.h>

#include "import/city_footprints.h"

namespace geom {
namespace {

CityObject object(const std::string& type, const std::string& name, double low, double high) {
  CityObject out{.type = type, .name = name, .whole = name};
  out.geometries.push_back(
      {.lod = 1,
       .roof_edge = false,
       .roofs_only = false,
       .surfaces = {{{{0, 0, low}, {9, 0, low}, {9, 9, high}, {0, 9, high}}}}});
  return out;
}

CityModel model_of(std::vector<CityObject> objects) {
  CityModel model;
  model.objects = std::move(objects);
  return model;
}

using Counts = std::map<std::string, std::size_t>;

TEST(LeaveOut, LeavesOutWhatLiesOnTheGroundAndSaysHowHighItRises) {
  CityModel model = model_of({object("Building", "b", 10, 30), object("LandUse", "l", 10, 12),
                              object("Road", "r", 10.5, 11), object("TINRelief", "t", 10, 40)});
  const LeftOutTypes out = leave_out(model, {}, 1);
  EXPECT_EQ(out.count, (Counts{{"LandUse", 1}, {"Road", 1}}));
  EXPECT_EQ(out.rise, 2);
  EXPECT_EQ(footprints_of(model, 1, {}).objects, 2u);
}

TEST(LeaveOut, KeepsARoadThatRisesAboveTheGround) {
  CityModel model = model_of({object("Building", "b", 0, 30), object("LandUse", "l", 0, 1),
                              object("Road", "bridge", 0, 8)});
  EXPECT_EQ(leave_out(model, {}, 1).count, (Counts{{"LandUse", 1}}));
  CityModel feet = model_of({object("Building", "b", 0, 30), object("Road", "flat", 0, 8)});
  EXPECT_EQ(leave_out(feet, {}, 0.3048).count, (Counts{{"Road", 1}}));
}

TEST(LeaveOut, DoesNotCountWhatHasNoSurface) {
  CityModel model = model_of({object("Building", "b", 0, 30), object("Road", "r", 0, 0.5)});
  model.objects.push_back({.type = "Road", .name = "bare", .whole = "bare"});
  EXPECT_EQ(leave_out(model, {}, 1).count, (Counts{{"Road", 1}}));
}

TEST(LeaveOut, KeepsAllWhereNothingElseWouldBeLeft) {
  CityModel model = model_of({object("LandUse", "l", 0, 1), object("Road", "r", 0, 1)});
  EXPECT_TRUE(leave_out(model, {}, 1).count.empty());
  EXPECT_EQ(footprints_of(model, 1, {}).objects, 2u);
}

TEST(LeaveOut, BuildsTheTypesThatAreNamedWithTheirParts) {
  CityObject part = object("BuildingPart", "p", 0, 20);
  part.is_part = true;
  part.whole = "b";
  CityModel model = model_of({object("Building", "b", 0, 30), part, object("Bridge", "x", 0, 9),
                              object("Road", "r", 0, 9), object("Road", "s", 0, 1)});
  EXPECT_EQ(leave_out(model, {"Building", "Bridge"}, 1).count, (Counts{{"Road", 2}}));
  EXPECT_EQ(footprints_of(model, 1, {}).objects, 3u);
  EXPECT_EQ(types_of(model).at("Road"), 2u);
}

TEST(LeaveOut, SkipsNothingOfWhatIsLeftOut) {
  CityModel model = model_of({object("Building", "b", 0, 30)});
  model.objects.push_back({.type = "SolitaryVegetationObject", .name = "tree", .whole = "tree"});
  EXPECT_EQ(footprints_of(model, 1, {}).skipped.count(), 1u);
  leave_out(model, {"Building"}, 1);
  EXPECT_EQ(footprints_of(model, 1, {}).skipped.count(), 0u);
}

}  // namespace
}  // namespace geom
