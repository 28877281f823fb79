#pragma once

// GeoPackages: tables of lines and polygons with heights, for QGIS and other programs.
//
// Example, not run:
//   geom::gis::GeoTable ways{.name = "trajectories", .numbers = {"duration_s"}};
//   ways.rows.push_back({"q1", {{47.4, 8.5, 420}, {47.41, 8.5, 430}}, {12.5}, {}});
//   geom::gis::write_geopackage("flights.gpkg", {&ways, 1});

#include <span>
#include <string>
#include <vector>

#include "geom/map/geographic_frame.h"

namespace geom::gis {

struct GeoRow {
  std::string id;
  std::vector<GeodeticPlace> places;  // of a line, or the corners of a polygon, which is closed
  std::vector<double> numbers;        // one for each of the table's; NaN: none
  std::vector<std::string> texts;     // likewise; empty: none
  std::string note = {};              // in a column of its own, where any row of the table has one
};

struct GeoTable {
  std::string name;
  bool polygons = false;                  // else lines
  std::vector<std::string> numbers = {};  // names of columns
  std::vector<std::string> texts = {};
  std::vector<GeoRow> rows = {};
};

// Latitude and longitude of WGS 84, heights above its ellipsoid (EPSG:4979). The file is read back,
// and each coordinate compared. The file must not exist yet. This loads GDAL. Throws
// std::runtime_error where GDAL is not installed, or cannot write.
void write_geopackage(const std::string& path, std::span<const GeoTable> tables);

}  // namespace geom::gis
