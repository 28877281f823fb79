#include "geom/gis/axis_order.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom::gis {
namespace {

// A block of 20 m by 10 m whose roof faces up where x is east.
geom::CityModel block(const std::string& crs, double x, double y, double size = 1) {
  geom::CityObject object;
  geom::CityGeometry g;
  const auto at = [&](double i, double j, double z) {
    return geom::Vec3(x + i * size, y + j * size, z);
  };
  g.surfaces = {{{at(0, 0, 9), at(20, 0, 9), at(20, 10, 9), at(0, 10, 9)}},
                {{at(0, 0, 0), at(0, 10, 0), at(20, 10, 0), at(20, 0, 0)}}};
  object.geometries.push_back(g);
  geom::CityModel model;
  model.objects.push_back(object);
  model.crs = crs;
  return model;
}

geom::CityModel turned(geom::CityModel model) {
  for (auto& surface : model.objects[0].geometries[0].surfaces) {
    for (auto& ring : surface) {
      for (geom::Vec3& p : ring) std::swap(p.x(), p.y());
    }
  }
  return model;
}

double first_x(geom::CityModel model, Axes axes = Axes::as_named, bool city_json = false) {
  orient(model, axes, city_json, "city");
  return model.objects[0].geometries[0].surfaces[0][0][0].x();
}

bool refused(const geom::CityModel& model) {
  return support::says(support::refusal_of([&] { first_x(model); }), "--axes");
}

TEST(AxisOrder, AUrnMeansTheOrderOfTheSystem) {
  const std::string degrees = "urn:ogc:def:crs:EPSG::4326";
  EXPECT_EQ(first_x(turned(block(degrees, 13.4, 52.5, 1e-5))), 13.4);
  EXPECT_EQ(first_x(turned(block("http://www.opengis.net/def/crs/EPSG/0/4326", 13.4, 52.5, 1e-5))),
            13.4);
  EXPECT_EQ(first_x(block("EPSG:4326", 13.4, 52.5, 1e-5)), 13.4);
  const std::string gauss = "urn:ogc:def:crs,crs:EPSG::31468,crs:EPSG::5783";
  EXPECT_EQ(first_x(turned(block(gauss, 4390000, 5820000))), 4390000);
}

TEST(AxisOrder, CityJsonMeansEastFirst) {
  EXPECT_EQ(first_x(block("EPSG:4326", 13.4, 52.5, 1e-5), Axes::as_named, true), 13.4);
}

TEST(AxisOrder, RefusesWhatLiesThereOnlyTheOtherWayRound) {
  EXPECT_TRUE(refused(block("urn:ogc:def:crs:EPSG::31468", 4390000, 5820000)));
  EXPECT_TRUE(refused(turned(block("EPSG:25833", 390000, 5820000))));
  EXPECT_EQ(first_x(block("urn:ogc:def:crs:EPSG::31468", 4390000, 5820000), Axes::east_north),
            4390000);
  EXPECT_EQ(first_x(turned(block("EPSG:25833", 390000, 5820000)), Axes::north_east), 390000);
}

// Degrees that may be either way round: what faces up tells.
TEST(AxisOrder, RefusesWhatFacesInward) {
  EXPECT_TRUE(refused(block("urn:ogc:def:crs:EPSG::4326", 13.4, 52.5, 1e-5)));
  EXPECT_TRUE(refused(turned(block("EPSG:4326", 13.4, 52.5, 1e-5))));
}

TEST(AxisOrder, KnowsTheSystemsOfTheGermanSurveys) {
  geom::CityModel model = block("urn:adv:crs:ETRS89_UTM32*DE_DHHN92_NH", 457842, 5439083);
  orient(model, Axes::as_named, false, "city");
  EXPECT_EQ(model.crs, "EPSG:25832");
  for (const char* name :
       {"urn:adv:crs:DE_DHDN_3GK4*DE_DHHN92_NH", "urn:adv:crs:DE_DHDN_3GK4*DE_DHN92_NH"}) {
    model.crs = name;
    orient(model, Axes::east_north, false, "city");
    EXPECT_EQ(model.crs, "EPSG:31468");
  }
}

TEST(AxisOrder, RefusesASystemThatNobodyKnows) {
  geom::CityModel model = block("urn:adv:crs:nothing", 1, 2);
  EXPECT_THROW(orient(model, Axes::as_named, false, "city"), geom::InputError);
  model.crs = "CRS:84";
  EXPECT_TRUE(orient(model, Axes::as_named, false, "city")->is_geographic());
  model.crs = "osgb:BNG";
  EXPECT_TRUE(orient(model, Axes::as_named, false, "city"));
  EXPECT_EQ(model.crs, "EPSG:27700");
}

TEST(AxisOrder, LeavesLocalMetresAsTheyAre) { EXPECT_EQ(first_x(block("", 4, 5)), 4); }

}  // namespace
}  // namespace geom::gis
