#include "gis/gdal_gml.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "geom/gis/footprint_source.h"
#include "support/memory_file.h"
#include "support/reading.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

std::string square(double west) {
  return fmt::format(
      "<gml:Polygon><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>{0},0 {1},0 {1},9 {0},9 "
      "{0},0</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon>",
      west, west + 9);
}

std::string member(const std::string& type, const std::string& content) {
  return fmt::format("<gml:featureMember><a:{0} fid=\"{0}.0\">{1}</a:{0}></gml:featureMember>",
                     type, content);
}

std::string collection(const std::string& members) {
  return "<a:C xmlns:a=\"a\" xmlns:gml=\"http://www.opengis.net/gml\">" + members + "</a:C>";
}

const std::string kHouse =
    member("house", "<a:height>20</a:height><a:plan>" + square(0) + "</a:plan>");
const std::string kTower =
    member("tower", "<a:height>90</a:height><a:plan>" + square(50) + "</a:plan>");

Source read(const std::string& members) {
  return read_text("city.gml", collection(members), ReadOptions{});
}

TEST(ReadGml, TakesEachFeature) { EXPECT_EQ(read(kHouse + kTower).footprints.size(), 2u); }

// GDAL reads the last of them.
TEST(ReadGml, RefusesASecondGeometryOfAFeature) {
  for (const char* property : {"plan", "roof"}) {
    const std::string two =
        member("house", fmt::format("<a:height>20</a:height><a:plan>{0}</a:plan><a:{1}>{2}</a:{1}>",
                                    square(0), property, square(50)));
    EXPECT_TRUE(says(refusal_of([&] { read(two); }),
                     "its features have 2 geometries and 2 polygons, and GDAL reads 1 and 1"));
  }
}

// GDAL reads the first alone.
TEST(ReadGml, RefusesASecondPolygonOfAMember) {
  const auto house = [](const std::string& surfaces) {
    return member("house", "<a:height>20</a:height><a:plan><gml:MultiSurface>" + surfaces +
                               "</gml:MultiSurface></a:plan>");
  };
  const auto surface = [](const std::string& polygons) {
    return "<gml:surfaceMember>" + polygons + "</gml:surfaceMember>";
  };
  EXPECT_EQ(read(house(surface(square(0)) + surface(square(50)))).footprints.size(), 2u);
  const std::string two = house(surface(square(0) + square(50)));
  EXPECT_TRUE(says(refusal_of([&] { read(two); }),
                   "its features have 1 geometry and 2 polygons, and GDAL reads 1 and 1"));
  ReadOptions options;
  options.where = "height > 0";
  EXPECT_TRUE(says(refusal_of([&] { read_text("city.gml", collection(two), options); }),
                   "GDAL reads 1 and 1"));
}

// GDAL reads such in pairs.
TEST(ReadGml, RefusesThreeNumbersAPointThatDoNotSaySo) {
  const auto house = [](const std::string& dimension) {
    return member("house",
                  "<a:height>20</a:height><a:plan><gml:Polygon><gml:exterior><gml:LinearRing>"
                  "<gml:posList" +
                      dimension +
                      ">0 0 5 9 0 5 9 9 5 0 0 5</gml:posList>"
                      "</gml:LinearRing></gml:exterior></gml:Polygon></a:plan>");
  };
  EXPECT_EQ(read(house(" srsDimension=\"3\"")).footprints.at(0).top, 25);
  EXPECT_TRUE(
      says(refusal_of([&] { read(kHouse + house("")); }), "give lists of three numbers a point"));
}

// It tells GDAL to look for houses alone.
TEST(ReadGml, KnowsNothingOfATemplateBesideTheFile) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.gml";
  std::ofstream(path) << collection(kHouse + kTower);
  std::ofstream(folder / "city.gfs")
      << "<GMLFeatureClassList><GMLFeatureClass><Name>house</Name><ElementPath>house</ElementPath>"
         "<GeometryElementPath>plan</GeometryElementPath></GMLFeatureClass></GMLFeatureClassList>";
  EXPECT_EQ(read_vector(path, path, {}).footprints.size(), 2u);
}

TEST(ReadGml, LeavesNothingBesideTheFile) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "city.gml";
  std::ofstream(path) << collection(kHouse);
  read_vector(path, path, {});
  EXPECT_FALSE(std::filesystem::exists(folder / "city.gfs"));
}

// GDAL takes its number in the unit of the coordinates, and in degrees takes east for north.
TEST(ReadGml, RefusesARadiusThatIsNotInMetres) {
  const auto refusal = [](const std::string& system, const std::string& uom) {
    const std::string tank = member(
        "house", fmt::format("<a:height>20</a:height><a:plan><gml:Polygon srsName=\"{}\">"
                             "<gml:exterior><gml:Ring><gml:curveMember><gml:Curve><gml:segments>"
                             "<gml:CircleByCenterPoint numArc=\"1\"><gml:pos>50 45</gml:pos>"
                             "<gml:radius{}>10</gml:radius></gml:CircleByCenterPoint>"
                             "</gml:segments></gml:Curve></gml:curveMember></gml:Ring>"
                             "</gml:exterior></gml:Polygon></a:plan>",
                             system, uom));
    return refusal_of([&] { read(tank); });
  };
  EXPECT_EQ(refusal("EPSG:32632", " uom=\"m\""), "");
  EXPECT_EQ(refusal("EPSG:32632", " uom=\"urn:ogc:def:uom:EPSG::metre\""), "");
  EXPECT_TRUE(says(refusal("EPSG:32632", " uom=\"km\""),
                   "the radius of an arc about its centre: expected metres, and coordinates in "
                   "metres, found \"km\""));
  EXPECT_TRUE(says(refusal("EPSG:32632", ""), "expected metres"));
  for (const char* system : {"EPSG:4326", "urn:ogc:def:crs:EPSG::4326", "EPSG:2263"}) {
    EXPECT_TRUE(says(refusal(system, " uom=\"m\""), "found coordinates in another unit"));
  }
}

TEST(ReadGml, ObeysTheUnitOfAHeight) {
  const auto house = [](const std::string& unit) {
    return member("house",
                  "<a:height uom=\"" + unit + "\">20</a:height><a:plan>" + square(0) + "</a:plan>");
  };
  EXPECT_EQ(read(house("urn:ogc:def:uom:UCUM::m")).footprints.at(0).top, 20);
  EXPECT_DOUBLE_EQ(read(house("ft")).footprints.at(0).top, 20 * 0.3048);
  EXPECT_EQ(read(house("furlong")).skipped.count(), 1u);
}

TEST(ReadVector, CountsFurtherColumnsOfGeometries) {
  const Source source = read_text(
      "a.csv",
      "WKT,height,_WKTroof\n\"POLYGON((0 0,9 0,9 9,0 0))\",12,\"POLYGON((50 0,59 0,59 9,50 0))\"\n"
      "\"POLYGON((0 0,9 0,9 9,0 0))\",12,\n",
      ReadOptions{});
  EXPECT_EQ(source.footprints.size(), 2u);
  EXPECT_EQ(source.skipped.text(), "1 x further geometry of a feature (feature 1 of layer a)");
}

}  // namespace
}  // namespace geom::gis
