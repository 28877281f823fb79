#pragma once

// Cells of a raster that counts people, and where on Earth they are.
//
// Example, not run:
//   const auto cells = geom::gis::people_within("ghs-pop.tif", {47.3, 8.4}, {47.5, 8.6});
//   for (const geom::gis::PeopleCell& cell : cells) std::cout << cell.people.value_or(0) << '\n';

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polygon.h"

namespace geom::gis {

struct PeopleCell {
  std::size_t row = 0;  // of the raster, counted from its top
  std::size_t column = 0;
  std::optional<double> people = {};          // absent: the raster says that it has no number
  std::array<GeodeticPlace, 4> corners = {};  // in turn
};

// All cells of the rows and columns that hold the places between two corners (latitude, longitude),
// and one more on each side, row by row; none where the raster does not reach there. This loads
// GDAL. Throws InputError unless the file is a raster of one band with a reference system, for
// numbers below 0 other than its value for "no data", and for more than 4 million cells;
// std::runtime_error where GDAL is not installed.
std::vector<PeopleCell> people_within(const std::string& path, const Vec2& low, const Vec2& high);

}  // namespace geom::gis
