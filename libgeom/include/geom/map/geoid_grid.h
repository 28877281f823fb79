#pragma once

// Grids that say how high the sea level (geoid) is above the ellipsoid.
//
// Example:
//   std::ifstream file("/usr/share/proj/egm96_15.gtx", std::ios::binary);
//   if (file) {
//     const geom::GeoidGrid grid = geom::read_geoid_grid(file, "egm96_15.gtx");
//     const auto zurich = grid.over({47.3, 47.5, 8.4, 8.7});
//     assert(zurich && zurich->least > 45 && zurich->most < 50);
//   }

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geom {

// Degrees; south <= north, west <= east, which may be beyond 180.
struct GeoidArea {
  double south = 0;
  double north = 0;
  double west = 0;
  double east = 0;
};

struct GeoidRange {  // metres above the ellipsoid
  double least = 0;
  double most = 0;
};

// Heights at the crossings of meridians and parallels, with straight slopes between them.
struct GeoidGrid {
  double south = 0;  // of the first row, degrees
  double west = 0;   // of the first column
  double north_step = 0;
  double east_step = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<float> heights;  // row by row, from the south; NaN: not known
  double error = 0;            // metres that the geoid may be beside the slopes

  // Bounds of the geoid over an area, with the error. Nothing where the grid does not know it all
  // over.
  std::optional<GeoidRange> over(const GeoidArea& area) const;
};

// A grid of GeographicLib (.pgm, which says its error) or of PROJ (.gtx, which does not). The error
// of a .gtx is taken as that of EGM96 in steps of a quarter of a degree, 1.2 m, and grows by the
// square of longer steps. Throws InputError(source, …) for anything else.
GeoidGrid read_geoid_grid(std::istream& in, std::string_view source);

// The bytes of a grid of PROJ that holds the part over an area, and a node or two around it. Throws
// InputError("the geoid grid", …) where the grid does not know the area, or says an error beyond
// that of such a file.
std::string gtx_over(const GeoidGrid& grid, const GeoidArea& area);

}  // namespace geom
