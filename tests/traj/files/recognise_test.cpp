#include "traj/files/recognise.h"

#include <gtest/gtest.h>

#include <string>

namespace traj::files {
namespace {

using std::string_literals::operator""s;

std::string what(const std::string& head) {
  const geom::Format* const format = recognise(head);
  return format ? described(*format, head) : "nothing";
}

std::string zip(const std::string& name, const std::string& content) {
  std::string head = "PK\x03\x04" + std::string(22, '\0');
  head += static_cast<char>(name.size());
  head += std::string(3, '\0');
  return head + name + content;
}

// Beside the samples of formats_test.cpp.
TEST(Recognise, KnowsOtherBeginningsOfAFormat) {
  EXPECT_EQ(what("VERSION .7\nFIELDS x y z\nDATA ascii\n"), "a PCD point cloud");
  EXPECT_EQ(what("MM\0*\0"s), "a TIFF or GeoTIFF picture");
  EXPECT_EQ(what(R"({ "type" : "CityJSON","version":"1.1")"), "a CityJSON model");
  EXPECT_EQ(what("<kml xmlns=\"http://www.opengis.net/kml/2.2\">"), "a KML file");
  EXPECT_EQ(what(zip("streets.shp", "")), "a Shapefile in a ZIP archive (.shz)");
  EXPECT_EQ(what("QGC WPL 110\n0\t1\t0\t16\t"), "a mission (WPL)");
  EXPECT_EQ(what("QGC WPL 110\n0\t1\t0\t16\t0\n1\t0\t3\t5001\t4\t"),
            "a fence or rally points without a mission");
  EXPECT_EQ(what(R"({"fileType": "Plan", "geoFence": {)"), "a QGroundControl plan");
  EXPECT_EQ(
      what(zip("meta.json", R"({"format":"skyway-roadmap","lattice":{"format":"skyway-lattice")")),
      "a roadmap");
  EXPECT_EQ(what(zip("meta.json", R"({"content":{},"format":"skyway-shard")")), "a shard");
  EXPECT_EQ(what(zip("[Content_Types].xml", "")), "an office document");
  EXPECT_EQ(what("id,t_s,east_m,north_m,up_m,"), "a flight log");
  EXPECT_EQ(what("t_s,x_m,y_m\n"), "a table of setpoints");
  EXPECT_EQ(what("t_s,n_m,e_m,d_m\n"), "a table of setpoints");
}

TEST(Recognise, NamesStreamsByTheTypeOfTheirFirstRecord) {
  EXPECT_EQ(what(R"({"type":"enclosure","id":"a","from":[0,0,0],"to":[1,0,0]})"),
            "a stream of certificates");
  EXPECT_EQ(what(R"({"type":"contingencies","id":"a"})"), "a stream of certificates");
  EXPECT_EQ(what(R"({"type":"returns","id":"a"})"), "a stream of certificates");
  EXPECT_EQ(what(R"({"type":"tube_certificate","id":"a"})"), "a stream of certificates");
  EXPECT_EQ(what(R"({"type":"pair","ids":["a","b"]})"), "a stream of reports");
  EXPECT_EQ(what(R"({"type":"query","from":[0,0,0],"to":[1,0,0]})"), "a stream of queries");
  EXPECT_EQ(what(R"({"type":"FeatureCollection","features":[{"properties":{"type":"tree"}}]})"),
            "a GeoJSON file");
}

TEST(Recognise, NamesTablesOfPointsByTwoRows) {
  EXPECT_EQ(what("x y z\n0.2,0.3,1e-3,7\n"), "a table of points");
  EXPECT_EQ(what("1 2 3\n4 5\n"), "nothing");
  EXPECT_EQ(what("1 2 3 4 5\n1 2 3 4 5\n"), "nothing");
}

TEST(Recognise, ShowsTheFirstEntryOfAZip) {
  EXPECT_EQ(what(zip("a/b\x1b.txt", "")), "a ZIP archive whose first entry is \"a/b\\x1b.txt\"");
}

TEST(Recognise, SaysNothingOfPlainText) {
  for (const char* const text :
       {"", "posX,posY,posZ\n", "1 2 3\n", "P", "{", "lat0 37.7, lon0 -122.4\n"}) {
    EXPECT_EQ(what(text), "nothing") << text;
  }
}

TEST(Recognise, TakesTheNameOfAModelWhereItsBytesTellNothing) {
  const auto what_of = [&](const std::string& name, const std::string& bytes) -> std::string {
    const geom::Format* const format = recognise(bytes, name);
    return format ? std::string(format->what) : "nothing";
  };
  EXPECT_EQ(what_of("house.OBJ", "v 1 2 3\n"), "an OBJ model");
  EXPECT_EQ(what_of("house.3ds", "MM"), "a 3DS model");
  EXPECT_EQ(what_of("map.obj", zip("meta.json", R"({"format":"skyway-boxmap")")), "a box map");
  EXPECT_EQ(what_of("empty.obj", ""), "nothing");
  EXPECT_EQ(what_of("house.txt", "v 1 2 3\n"), "nothing");
  EXPECT_EQ(what_of("city.osm.gz", "\x1f\x8b\x08"), "a packed OpenStreetMap extract");
  EXPECT_EQ(what_of("city.gz", "\x1f\x8b\x08"), "a gzip archive");
}

TEST(Recognise, LooksAtWhatIsThere) {
  for (std::size_t size = 0; size < 120; ++size) {
    recognise(zip("meta.json", "").substr(0, size));
    recognise(("SQLite format 3\0"s + std::string(90, '\0')).substr(0, size));
  }
}

}  // namespace
}  // namespace traj::files
