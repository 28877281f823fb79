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

std::string las(char format, const std::string& more = {}) {
  std::string head = "LASF" + std::string(371, '\0');
  head[104] = format;
  return head + more;
}

std::string zip(const std::string& name, const std::string& content) {
  std::string head = "PK\x03\x04" + std::string(22, '\0');
  head += static_cast<char>(name.size());
  head += std::string(3, '\0');
  return head + name + content;
}

TEST(Recognise, NamesPointClouds) {
  EXPECT_EQ(what("ASTM-E57\1\0\0\0"s), "an E57 point cloud");
  EXPECT_EQ(what(las(3)), "a LAS point cloud");
  EXPECT_EQ(what(las('\x83')), "a LAZ point cloud");
  EXPECT_EQ(what(las('\x86', "\0\0copc"s)), "a COPC point cloud (LAZ)");
  EXPECT_EQ(what("# .PCD v0.7\n"), "a PCD point cloud");
  EXPECT_EQ(what("VERSION .7\nFIELDS x y z\nDATA ascii\n"), "a PCD point cloud");
  EXPECT_EQ(what("ply\nformat ascii 1.0\n"), "a PLY file");
  EXPECT_EQ(what("# Octomap OcTree binary file\n"), "an OctoMap (.bt)");
  EXPECT_EQ(what("# Octomap OcTree file\n"), "a full OctoMap (.ot)");
}

TEST(Recognise, NamesMapsOfTheWorld) {
  EXPECT_EQ(what("II*\0\x08"s), "a TIFF or GeoTIFF picture");
  EXPECT_EQ(what("MM\0*\0"s), "a TIFF or GeoTIFF picture");
  EXPECT_EQ(what("\0\0\x27\x0a\0"s), "a Shapefile");
  EXPECT_EQ(what("fgb\x03"s + "fgb"), "a FlatGeobuf");
  EXPECT_EQ(what("\0\0\0\x0d\x0a\x09OSMHeader"s), "an OpenStreetMap extract (.osm.pbf)");
  EXPECT_EQ(what("<?xml version='1.0'?>\n<osm version=\"0.6\">"), "an OpenStreetMap file");
  EXPECT_EQ(what("SQLite format 3\0"s + std::string(52, '\0') + "GPKG"), "a GeoPackage");
  EXPECT_EQ(what("SQLite format 3\0"s + std::string(90, '\0')), "an SQLite database");
  EXPECT_EQ(what(R"({"type": "FeatureCollection", "features": [)"), "a GeoJSON file");
  EXPECT_EQ(what(R"({ "type" : "CityJSON","version":"1.1")"), "a CityJSON model");
  EXPECT_EQ(what("<?xml?><core:CityModel xmlns"), "a CityGML model");
}

TEST(Recognise, NamesMissionsTracksAndLogs) {
  EXPECT_EQ(what("<?xml version=\"1.0\"?><gpx version=\"1.1\">"), "a GPX track");
  EXPECT_EQ(what("<?xml?><kml xmlns:wpml=\"x\"><wpml:missionConfig>"), "a DJI mission (WPML)");
  EXPECT_EQ(what("<kml xmlns=\"http://www.opengis.net/kml/2.2\">"), "a KML file");
  EXPECT_EQ(what(zip("wpmz/template.kml", "")), "a DJI mission (KMZ with WPML)");
  EXPECT_EQ(what(zip("doc.kml", "")), "a KMZ file");
  EXPECT_EQ(what(zip("streets.shp", "")), "a Shapefile in a ZIP archive (.shz)");
  EXPECT_EQ(what(zip("streets.dbf", "")), "a Shapefile in a ZIP archive (.shz)");
  EXPECT_EQ(what("QGC WPL 110\n0\t1\t0\t16\t"), "a mission (WPL)");
  EXPECT_EQ(what("QGC WPL 110\n0\t1\t0\t16\t0\n1\t0\t3\t5001\t4\t"),
            "a fence or rally points without a mission");
  EXPECT_EQ(what(R"({"fileType": "Plan", "geoFence": {)"), "a QGroundControl plan");
  EXPECT_EQ(what("ULog\x01\x12\x35\x01"), "a PX4 flight log (ULog)");
  EXPECT_EQ(what("\xa3\x95\x80\x80"), "an ArduPilot flight log (DataFlash .bin)");
  EXPECT_EQ(what("\0\x05\xe1\x02\x03\x04\x05\x06\xfd\x09"s), "a telemetry log (tlog)");
  EXPECT_EQ(what("#ROSBAG V2.0\n"), "a ROS bag");
}

TEST(Recognise, NamesOurOwnFiles) {
  EXPECT_EQ(what(zip("meta.json", R"({"format":"skyway-boxmap")")), "a box map");
  EXPECT_EQ(what(zip("meta.json", R"({"format":"skyway-lattice")")), "a lattice");
  EXPECT_EQ(what(zip("meta.json", R"({"format":"skyway-roadmap")")), "a roadmap");
  EXPECT_EQ(
      what(zip("meta.json", R"({"format":"skyway-roadmap","lattice":{"format":"skyway-lattice")")),
      "a roadmap");
  EXPECT_EQ(what(zip("meta.json", R"({"content":{},"format":"skyway-shard")")), "a shard");
  EXPECT_EQ(what(R"({"type":"path","id":"a")"), "a stream of paths");
  EXPECT_EQ(what(R"({"type":"trajectory","id":"a")"), "a stream of trajectories");
  EXPECT_EQ(what(R"({"type":"moving","id":"a")"), "a stream of obstacles that move");
  EXPECT_EQ(what(R"({"type":"report","id":"a")"), "a stream of reports");
  EXPECT_EQ(what(R"({"id":"q1","from":[0,0,0],"to":[1,0,0]})"), "a stream of queries");
  EXPECT_EQ(what("id,from_x,from_y,from_z,to_x,to_y,to_z\n"), "a table of queries");
  EXPECT_EQ(what("id,t_s,east_m,north_m,up_m,"), "a flight log");
  EXPECT_EQ(what("id,t_s,x_m,y_m,z_m,"), "a flight log");
  EXPECT_EQ(what(R"({"name": "quad", "tilt_max_deg": 35})"), "a vehicle profile");
}

TEST(Recognise, NamesStreamsByTheTypeOfTheirFirstRecord) {
  EXPECT_EQ(what(R"({"type":"enclosure","id":"a","from":[0,0,0],"to":[1,0,0]})"),
            "a stream of certificates");
  EXPECT_EQ(what(R"({"type":"pair","ids":["a","b"]})"), "a stream of reports");
  EXPECT_EQ(what(R"({"type":"query","from":[0,0,0],"to":[1,0,0]})"), "a stream of queries");
  EXPECT_EQ(what(R"({"type":"FeatureCollection","features":[{"properties":{"type":"tree"}}]})"),
            "a GeoJSON file");
}

TEST(Recognise, NamesTextsByHowTheyBegin) {
  EXPECT_EQ(what("duration,x^0,x^1\n"), "a Crazyflie trajectory");
  EXPECT_EQ(what("t_s,east_m,north_m\n"), "a table of setpoints");
  EXPECT_EQ(what("t_s,x_m,y_m\n"), "a table of setpoints");
  EXPECT_EQ(what("command\ntakeoff\n"), "a Tello script");
  EXPECT_EQ(what("boundary 0 0 0 1 1 1\n"), "a block text");
  EXPECT_EQ(what("voxel 4 5 6\n"), "a list of voxels (.3dmap)");
  EXPECT_EQ(what("- origin: [0, 0, 0]\n"), "a jps3d map");
  EXPECT_EQ(what("<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">"), "a Gazebo world (SDF)");
  EXPECT_EQ(what("ncols 4\n"), "a height model (ASCII grid)");
  EXPECT_EQ(what(R"({"bounds": {"extents": [0, 1]}})"), "a RotorPy world");
}

TEST(Recognise, NamesTablesOfPointsByTwoRows) {
  EXPECT_EQ(what("1 2 3\n4 5 6\n"), "a table of points");
  EXPECT_EQ(what("x y z\n0.2,0.3,1e-3,7\n"), "a table of points");
  EXPECT_EQ(what("1 2 3\n4 5\n"), "nothing");
  EXPECT_EQ(what("1 2 3 4 5\n1 2 3 4 5\n"), "nothing");
}

TEST(Recognise, NamesWhatNobodyReads) {
  EXPECT_EQ(what("\x89PNG\r\n\x1a\n"), "a PNG picture");
  EXPECT_EQ(what("\xff\xd8\xff\xe0"), "a JPEG picture");
  EXPECT_EQ(what("\x1f\x8b\x08"), "a gzip archive");
  EXPECT_EQ(what(zip("a/b\x1b.txt", "")), "a ZIP archive whose first entry is \"a/b\\x1b.txt\"");
  EXPECT_EQ(what(zip("[Content_Types].xml", "")), "an office document");
  EXPECT_EQ(what(std::string(257, 'a') + "ustar"), "a tar archive");
  EXPECT_EQ(what("\x89HDF\r\n\x1a\n"), "an HDF5 file");
  EXPECT_EQ(what("\x93NUMPY\x01"), "a NumPy array (.npy)");
  EXPECT_EQ(what("PAR1"), "a Parquet table");
  EXPECT_EQ(what("%PDF-1.7"), "a PDF document");
  EXPECT_EQ(what("\x7f"s + "ELF\x02"), "a program (ELF)");
  EXPECT_EQ(what("\xff\xfe{\0"s), "text in UTF-16");
  EXPECT_EQ(what("glTF\x02"), "a binary glTF");
}

TEST(Recognise, NamesTablesOfBoxesByTheirHeaders) {
  EXPECT_EQ(what("lat0 37.7, lon0 -122.4\nposX,posY,posZ,halfSizeX,halfSizeY,halfSizeZ\n"),
            "an FCND table of boxes");
  EXPECT_EQ(what("min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n"),
            "a table of boxes (box CSV)");
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
    recognise(las(3).substr(0, size));
    recognise(zip("meta.json", "").substr(0, size));
    recognise(("SQLite format 3\0"s + std::string(90, '\0')).substr(0, size));
  }
}

}  // namespace
}  // namespace traj::files
