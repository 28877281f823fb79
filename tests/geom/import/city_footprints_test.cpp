#include "import/city_footprints.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace geom {
namespace {

CitySurface square(double low, double high, double z) {
  return {{{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}}};
}

CityObject object(const std::string& type, std::vector<CityGeometry> geometries,
                  std::map<std::string, std::string> attributes = {}) {
  CityObject out;
  out.type = type;
  out.name = out.whole = "it";
  out.geometries = std::move(geometries);
  out.attributes = std::move(attributes);
  return out;
}

CityFootprints built(std::vector<CityObject> objects, double unit = 1) {
  CityModel model;
  model.objects = std::move(objects);
  return footprints_of(model, unit, {});
}

CityGeometry at_lod(double lod, std::vector<CitySurface> surfaces) {
  CityGeometry g;
  g.lod = lod;
  g.surfaces = std::move(surfaces);
  return g;
}

TEST(CityFootprints, FollowTheFinestSurfaces) {
  const CityFootprints out = built(
      {object("Building",
              {at_lod(1, {square(0, 9, 0), square(0, 9, 12)}),
               at_lod(2, {square(0, 9, 0), {{{0, 0, 4}, {9, 0, 4}, {9, 9, 10}, {0, 9, 10}}}})})});
  ASSERT_EQ(out.footprints.size(), 2u);
  EXPECT_EQ(out.footprints[1].bottom, 0);
  EXPECT_EQ(out.footprints[1].top, 10);
  EXPECT_EQ(out.footprints[1].heights, (std::vector<double>{4, 4, 10, 10}));
  EXPECT_TRUE(out.footprints[0].likely_covered);
  EXPECT_EQ(out.by_kind.at("Building LoD 2"), 1u);
}

TEST(CityFootprints, KeepACoarserShapeThatReachesFurther) {
  const CityFootprints out =
      built({object("Building", {at_lod(1, {square(0, 40, 0), square(0, 40, 12)}),
                                 at_lod(2, {square(0, 9, 0), square(0, 9, 15)})})});
  EXPECT_EQ(out.footprints.size(), 4u);
}

TEST(CityFootprints, KeepACoarserShapeThatRisesHigherOrHasTheRoofs) {
  const auto upright = [](double y, double low, double high) {
    return CitySurface{{{0, y, low}, {9, y, low}, {9, y, high}, {0, y, high}}};
  };
  const CityGeometry block = at_lod(1, {square(0, 9, 0), square(0, 9, 30)});
  const auto tops = [&](CityGeometry finer) {
    const auto out = built({object("Building", {std::move(finer), block})});
    return std::count_if(out.footprints.begin(), out.footprints.end(), [](const Footprint& f) {
      return f.top == 30 && f.polygon.outer[2].y() != f.polygon.outer[0].y();
    });
  };
  EXPECT_EQ(tops(at_lod(3, {upright(0, 2, 4), upright(9, 2, 4)})), 1) << "windows";
  EXPECT_EQ(tops(at_lod(2, {upright(0, 0, 30), upright(9, 0, 30)})), 1) << "walls";
  EXPECT_EQ(tops(at_lod(2, {square(0, 9, 0)})), 1) << "the ground of a building";
  EXPECT_EQ(tops(at_lod(2, {square(0, 9, 0), square(0, 9, 25)})), 0);
}

// Two ends of a hall; the middle is in the coarser shape alone.
TEST(CityFootprints, KeepACoarserShapeWhereTheFinerOneHasAGap) {
  const auto end = [](double from, double to, double z) {
    return CitySurface{{{from, 0, z}, {to, 0, z}, {to, 100, z}, {from, 100, z}}};
  };
  const CityGeometry ends =
      at_lod(2.2, {end(0, 34, 0), end(0, 34, 20), end(66, 100, 0), end(66, 100, 20)});
  const CityGeometry block = at_lod(1.2, {square(0, 100, 0), square(0, 100, 20)});
  EXPECT_EQ(built({object("Building", {ends, block})}).footprints.size(), 6u);
  const CityGeometry whole = at_lod(2.2, {end(0, 50, 0), end(0, 50, 20), end(50, 99.7, 19)});
  EXPECT_EQ(built({object("Building", {whole, block})}).footprints.size(), 3u);
}

TEST(CityFootprints, APlanWithoutRoofsOnAllOfItIsAsHighAsTheRest) {
  const auto tops = [](std::map<std::string, std::string> attributes) {
    const CityGeometry house = at_lod(2, {square(0, 80, 1), square(0, 80, 12)});
    const CityFootprints out =
        built({object("Building", {at_lod(0, {square(0, 100, 1)}), house}, std::move(attributes))});
    EXPECT_EQ(out.footprints.size(), 3u);
    return out.footprints.back().top;
  };
  EXPECT_EQ(tops({}), 12);
  EXPECT_EQ(tops({{"measuredHeight", "30"}}), 31);
  EXPECT_EQ(tops({{"measuredHeight", "5"}}), 12);
}

TEST(CityFootprints, TakeAllOfALevelTogether) {
  const CityFootprints out =
      built({object("Building", {at_lod(3, {{{{0, 0, 2}, {9, 0, 2}, {9, 0, 4}, {0, 0, 4}}}}),
                                 at_lod(2, {square(0, 9, 0)}), at_lod(2, {square(0, 9, 30)})})});
  ASSERT_EQ(out.footprints.size(), 3u);
  EXPECT_EQ(out.footprints[2].top, 30);
}

TEST(CityFootprints, CountInTheUnitOfTheModel) {
  const CityFootprints out = built(
      {object("Building",
              {at_lod(2, {square(0, 9, 0), {{{0, 0, 10}, {9, 0, 10}, {9, 9, 20}, {0, 9, 20}}}})})},
      0.3048);
  EXPECT_DOUBLE_EQ(out.footprints[1].top, 6.096);
  EXPECT_DOUBLE_EQ(out.footprints[1].heights[0], 3.048);
}

TEST(CityFootprints, AFlatBuildingIsAsHighAsItsAttributesSay) {
  const auto top = [](std::map<std::string, std::string> attributes) {
    const CityFootprints out =
        built({object("Building", {at_lod(0, {square(0, 9, 100)})}, std::move(attributes))});
    EXPECT_EQ(out.footprints.at(0).bottom, 100);
    EXPECT_EQ(out.heights.size(), 1u);
    return out.footprints.at(0).top;
  };
  EXPECT_DOUBLE_EQ(top({{"measuredHeight", "6.5 m"}}), 106.5);
  EXPECT_DOUBLE_EQ(top({{"measuredHeight", "10 ft"}}), 103.048);
  EXPECT_DOUBLE_EQ(top({{"storeysAboveGround", "4"}}), 112);
  EXPECT_DOUBLE_EQ(top({{"measuredHeight", "6.5"}, {"height", "20"}}), 120);
  EXPECT_DOUBLE_EQ(top({}), 110);
}

TEST(CityFootprints, AnEdgeOfARoofMayBeAtEitherEnd) {
  CityGeometry edge = at_lod(0, {square(0, 9, 100)});
  edge.roof_edge = true;
  const CityFootprints out = built({object("Building", {edge}, {{"measuredHeight", "6"}})});
  EXPECT_EQ(out.footprints[0].bottom, 94);
  EXPECT_EQ(out.footprints[0].top, 106);
}

TEST(CityFootprints, RoofsAloneNeedAMeasuredHeight) {
  CityGeometry roof = at_lod(2, {{{{0, 0, 4}, {9, 0, 4}, {9, 9, 10}, {0, 9, 10}}}});
  roof.roofs_only = true;
  EXPECT_EQ(built({object("Building", {roof})}).skipped.count(), 1u);
  const CityFootprints measured =
      built({object("Building", {roof}, {{"measuredHeight", "9.5 m"}})});
  EXPECT_EQ(measured.skipped.count(), 0u);
  EXPECT_EQ(measured.footprints[0].bottom, 0.5);
}

TEST(CityFootprints, PartsOfOneStandOnItsLowestPoint) {
  CityObject part = object("BuildingPart", {at_lod(2, {square(0, 9, 20), square(0, 9, 30)})});
  part.name = "part";
  part.is_part = true;
  const CityFootprints out =
      built({object("Building", {at_lod(2, {square(10, 19, 1), square(10, 19, 20)})}), part});
  for (const Footprint& f : out.footprints) EXPECT_EQ(f.bottom, 1);
}

TEST(CityFootprints, NameLinesBesideSurfaces) {
  CityObject house = object("Building", {at_lod(2, {square(0, 9, 0), square(0, 9, 15)})});
  house.others = 1;  // where it meets the ground
  EXPECT_TRUE(built({house}).skipped.empty());
  house.drawn = 1;
  EXPECT_EQ(built({house}).skipped.count(), 1u);
  EXPECT_EQ(built({house}).footprints.size(), 2u);
  house.type = "Road";
  EXPECT_TRUE(built({house}).skipped.empty());
}

TEST(CityFootprints, NameWhatHasNoHeight) {
  EXPECT_NE(built({object("CityFurniture", {at_lod(0, {square(0, 1, 5)})})})
                .skipped.text()
                .find("CityFurniture drawn flat"),
            std::string::npos);
  EXPECT_EQ(
      built({object("SolitaryVegetationObject", {at_lod(1, {square(0, 1, 5)})}, {{"height", "8"}})})
          .footprints[0]
          .top,
      13);
  EXPECT_EQ(built({object("Road", {at_lod(0, {square(0, 1, 5)})})}).footprints.size(), 1u);
}

// As the buildings of a country are published: a plan, and what stands on it as a part.
std::vector<CityObject> plan_and_part(double part_to) {
  CityObject building = object("Building", {at_lod(0, {square(0, 10, 1)})});
  building.has_parts = true;
  CityObject part =
      object("BuildingPart",
             {at_lod(2, {square(0, part_to, 1),
                         {{{0, 0, 4}, {part_to, 0, 4}, {part_to, part_to, 9}, {0, part_to, 9}}}})});
  part.is_part = true;
  return {building, part};
}

TEST(CityFootprints, APlanHasItsHeightFromThePartsThatStandOnIt) {
  for (const bool part_first : {false, true}) {
    auto objects = plan_and_part(9.7);
    if (part_first) std::swap(objects[0], objects[1]);
    const CityFootprints out = built(objects);
    EXPECT_TRUE(out.heights.empty());
    EXPECT_TRUE(out.skipped.empty());
    ASSERT_EQ(out.footprints.size(), 3u);
    const Footprint& plan = out.footprints[part_first ? 2 : 0];
    EXPECT_EQ(plan.top, 1);
    EXPECT_EQ(plan.bottom, 1);
  }
}

TEST(CityFootprints, APlanHasItsMeasuredHeightWherePartsStandOnOneAnother) {
  auto objects = plan_and_part(8);
  objects[0].attributes["measuredHeight"] = "30";
  objects.push_back(objects[1]);
  objects.push_back(objects[1]);
  const CityFootprints out = built(objects);
  EXPECT_EQ(out.footprints.at(0).top, 31);
  EXPECT_EQ(built({objects[0], plan_and_part(9.1)[1]}).footprints.at(0).top, 31);
}

// A wing that no part stands on may be as high as any.
TEST(CityFootprints, APlanThatPartsDoNotFillNeedsAHeight) {
  EXPECT_EQ(built(plan_and_part(8)).heights.size(), 1u);
  // As far as the plan in both directions, and half of it.
  auto objects = plan_and_part(10);
  objects[1] = object(
      "BuildingPart",
      {at_lod(2, {{{{0, 0, 1}, {10, 0, 1}, {0, 10, 1}}}, {{{0, 0, 4}, {10, 0, 4}, {0, 10, 9}}}})});
  objects[1].is_part = true;
  EXPECT_EQ(built(objects).heights.size(), 1u);
  // Drawn flat themselves.
  objects[1] = object("BuildingPart", {at_lod(0, {square(0, 10, 1)})});
  objects[1].is_part = true;
  EXPECT_EQ(built(objects).heights.size(), 2u);
  // Parts of another building.
  objects = plan_and_part(10);
  objects[1].whole = "another";
  EXPECT_EQ(built(objects).heights.size(), 1u);
}

}  // namespace
}  // namespace geom
