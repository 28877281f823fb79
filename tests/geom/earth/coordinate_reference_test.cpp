#include "geom/earth/coordinate_reference.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geom/base/error.h"
#include "geom/cloud/point_cloud.h"
#include "support/cases.h"
#include "support/las_file.h"

namespace {

using geom::CoordinateReference;
using Kind = CoordinateReference::Kind;
using support::LasFile;

constexpr const char* kProjected =
    "PROJCS[\"p\",GEOGCS[\"g\",UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_"
    "Mercator\"],"
    "UNIT[\"u\",{}]]";

TEST(WellKnownText, TheUnitIsThatOfThePlane) {
  const auto feet = geom::reference_of_wkt(fmt::format(fmt::runtime(kProjected), "0.3048"));
  EXPECT_EQ(feet.kind, Kind::metric);
  EXPECT_EQ(feet.plane, 0.3048);
  EXPECT_FALSE(feet.up);
  EXPECT_FALSE(feet.crs.empty());
}

TEST(WellKnownText, ACompoundSystemHasAUnitOfHeights) {
  const std::string plane = fmt::format(fmt::runtime(kProjected), "1");
  const auto both =
      geom::reference_of_wkt("COMPD_CS[\"c\"," + plane +
                             ",VERT_CS[\"v\",VERT_DATUM[\"d\",2005],UNIT[\"ft\",0.3048006096]]]");
  EXPECT_EQ(both.plane, 1.0);
  EXPECT_EQ(both.up, 0.3048006096);
  const auto open = geom::reference_of_wkt("COMPD_CS[\"c\"," + plane + ",VERT_CS[\"v\"]]");
  EXPECT_TRUE(open.up_unclear);
}

TEST(WellKnownText, Wkt2HasUnitsOfAxes) {
  const auto iso = geom::reference_of_wkt(
      "PROJCRS[\"p\",BASEGEOGCRS[\"b\",DATUM[\"d\",ELLIPSOID[\"e\",6378137,298.25,LENGTHUNIT["
      "\"metre\",1]]]],"
      "CONVERSION[\"c\",METHOD[\"Transverse Mercator\"],PARAMETER[\"False "
      "easting\",5,LENGTHUNIT[\"metre\",1]]],"
      "CS[Cartesian,2],AXIS[\"e\",east,LENGTHUNIT[\"US survey foot\",0.304800609601219]],"
      "AXIS[\"n\",north,LENGTHUNIT[\"US survey foot\",0.304800609601219]]]");
  EXPECT_EQ(iso.kind, Kind::metric);
  EXPECT_EQ(iso.plane, 0.304800609601219);
}

TEST(WellKnownText, DegreesAndWorldMercatorAreNoPlane) {
  EXPECT_EQ(geom::reference_of_wkt("GEOGCS[\"g\",UNIT[\"degree\",0.01745]]").kind, Kind::no_plane);
  EXPECT_EQ(geom::reference_of_wkt("GEOCCS[\"g\",UNIT[\"metre\",1]]").kind, Kind::no_plane);
  EXPECT_EQ(
      geom::reference_of_wkt("PROJCS[\"w\",PROJECTION[\"Mercator_1SP\"],UNIT[\"metre\",1]]").kind,
      Kind::no_plane);
}

TEST(WellKnownText, WhatIsNotUnderstoodIsSaidToBe) {
  for (const char* text :
       {"", "hello", "PROJCS[\"a\"", "PROJCS[\"a\"]]", "FOO[1]", "PROJCS[\"a,1]"}) {
    EXPECT_EQ(geom::reference_of_wkt(text).kind, Kind::not_known) << text;
  }
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "A[";
  EXPECT_EQ(geom::reference_of_wkt(deep).kind, Kind::not_known);
  EXPECT_FALSE(geom::reference_of_wkt("PROJCS[\"p\"]").plane);
}

TEST(GeoKeys, UnitsByCodeAndByUtm) {
  const auto of = [](const std::vector<std::pair<std::uint16_t, std::uint16_t>>& keys) {
    const LasFile::Record record = LasFile::geo_keys(keys);
    std::vector<std::uint16_t> directory(record.data.size() / 2);
    std::memcpy(directory.data(), record.data.data(), record.data.size());
    return geom::reference_of_geo_keys(directory, {});
  };
  EXPECT_EQ(of({{1024, 1}, {3072, 32610}}).plane, 1.0);
  EXPECT_EQ(of({{1024, 1}, {3072, 32610}}).crs, "EPSG:32610");
  EXPECT_EQ(of({{1024, 1}, {3072, 2992}, {3076, 9002}}).plane, 0.3048);
  EXPECT_FALSE(of({{1024, 1}, {3072, 2992}}).plane);
  EXPECT_EQ(of({{1024, 1}, {3072, 32610}, {4099, 9003}}).up, 1200.0 / 3937);
  EXPECT_EQ(of({{1024, 1}, {3072, 32610}, {4096, 5703}}).up, 1.0);
  // The unit's key and the system's own unit, where the plane has no name that PROJ could look up.
  const auto both = [&](std::uint16_t unit) {
    return of({{1024, 1}, {3072, 32767}, {3076, 9002}, {4096, 5703}, {4099, unit}});
  };
  EXPECT_EQ(both(9001).up, 1.0);
  EXPECT_FALSE(both(9002).up);
  EXPECT_TRUE(both(9002).up_unclear);
  EXPECT_TRUE(of({{1024, 1}, {3072, 32610}, {4096, 5200}}).up_unclear);
  EXPECT_EQ(of({{1024, 1}, {3072, 32610}}).epsg, 32610);
  EXPECT_FALSE(of({{1024, 1}, {3072, 32767}, {3076, 9002}}).epsg);  // user-defined
  EXPECT_EQ(of({{1024, 2}, {2048, 4326}}).kind, Kind::no_plane);
  EXPECT_EQ(of({{1024, 1}, {3072, 3857}}).kind, Kind::no_plane);
}

CoordinateReference told_by(const LasFile& file) {
  std::istringstream in(file.bytes());
  CoordinateReference out;
  geom::read_las(
      in, "t", [](auto) {}, [&](const CoordinateReference& told) { out = told; });
  return out;
}

TEST(Las, RefusesReferencesThatContradictEachOther) {
  LasFile file;
  file.points = {{1, 2, 3}};
  file.records = {LasFile::geo_keys({{1024, 1}, {3072, 32610}, {3076, 9001}}),
                  LasFile::text(fmt::format(fmt::runtime(kProjected), "0.3048"))};
  EXPECT_THROW(told_by(file), geom::InputError);
}

TEST(Las, RefusesReferencesOfOtherPlacesOrOtherUnitsOfHeight) {
  const auto file_of = [](const std::string& text, std::uint16_t code, std::uint16_t up) {
    LasFile file;
    file.points = {{1, 2, 3}};
    file.records = {LasFile::geo_keys({{1024, 1}, {3072, code}, {3076, 9001}, {4099, up}}),
                    LasFile::text(text)};
    return file;
  };
  const std::string utm10 =
      "PROJCS[\"WGS 84 / UTM zone 10N\",UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"32610\"]]";
  const std::string feet_up = "COMPD_CS[\"c\"," + utm10 + ",VERT_CS[\"v\",UNIT[\"ft\",0.3048]]]";
  EXPECT_EQ(told_by(file_of(utm10, 32610, 9001)).epsg, 32610);
  EXPECT_EQ(told_by(file_of(feet_up, 32610, 9002)).up, 0.3048);
  EXPECT_THROW(told_by(file_of(utm10, 32611, 9001)), geom::InputError);
  EXPECT_THROW(told_by(file_of(feet_up, 32610, 9001)), geom::InputError);
  EXPECT_THROW(told_by(file_of(feet_up, 32610, 9003)), geom::InputError);  // two kinds of feet
}

// A record that is said to be shorter or longer than it is hides those behind it, and so does a
// count of fewer records.
TEST(Las, RefusesAReferenceThatWrongLengthsHide) {
  LasFile file;
  file.points = {{1, 2, 3}};
  file.records = {{"other", 7, std::string(60, '\0')},
                  LasFile::geo_keys({{1024, 1}, {3072, 32610}})};
  const std::string whole = file.bytes();
  constexpr std::size_t kCount = 100;
  constexpr std::size_t kLength = 227 + 20;
  const auto is_told = [&](std::size_t place, std::uint16_t value) {
    std::string bytes = whole;
    std::memcpy(bytes.data() + place, &value, sizeof value);
    std::istringstream in(bytes);
    bool known = false;
    geom::read_las(
        in, "t", [](auto) {},
        [&](const CoordinateReference& told) { known = told.kind != Kind::none; });
    return known;
  };
  EXPECT_TRUE(is_told(kLength, 60));
  for (std::uint16_t length = 0; length < 200; ++length) {
    if (length == 60) continue;
    EXPECT_THROW(is_told(kLength, length), geom::InputError) << length;
  }
  EXPECT_THROW(is_told(kCount, 1), geom::InputError);
  EXPECT_THROW(is_told(kCount, 0), geom::InputError);
}

TEST(Las, RefusesPointsThatTheHeaderDoesNotCount) {
  LasFile file;
  file.points = {{1, 2, 3}, {4, 5, 6}};
  std::istringstream in(file.bytes() + std::string(20, '\0'));
  EXPECT_THROW(geom::read_las(in, "t", [](auto) {}), geom::InputError);
}

// Ten thousand files in some unit, told by keys, by text, or by both: the unit comes out, or
// nothing does and then the file named none.
TEST(Las, TellsEveryUnitThatAFileNames) {
  std::mt19937 random(7);
  const std::pair<std::uint16_t, double> units[] = {
      {9001, 1.0}, {9002, 0.3048}, {9003, 1200.0 / 3937}, {9036, 1000.0}};
  for (int i = 0; i < support::cases(10000); ++i) {
    const auto& [code, metres] = units[random() % 4];
    const auto& [up_code, up_metres] = units[random() % 3];
    const unsigned how = random() % 4;
    const bool vertical = random() % 2;
    LasFile file;
    file.points = {{double(random() % 1000), 2, 3}};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> keys = {
        {1024, 1}, {3072, 2992}, {3076, code}};
    if (vertical) keys.emplace_back(4099, up_code);
    std::string text = fmt::format(fmt::runtime(kProjected), metres);
    if (vertical)
      text = fmt::format("COMPD_CS[\"c\",{},VERT_CS[\"v\",UNIT[\"u\",{}]]]", text, up_metres);
    if (how & 1) file.records.push_back(LasFile::geo_keys(keys));
    if (how & 2) file.records.push_back(LasFile::text(text));
    if (random() % 2) file.records.push_back({"other", 7, std::string(random() % 50, 'x')});
    file.well_known_text = how & 2;
    const CoordinateReference told = told_by(file);
    if (how == 0) {
      ASSERT_EQ(told.kind, Kind::none) << i;
      continue;
    }
    ASSERT_EQ(told.kind, Kind::metric) << i;
    ASSERT_EQ(told.plane, metres) << i;
    if (vertical) {
      ASSERT_EQ(told.up, up_metres) << i;
    }
  }
}

}  // namespace
