#pragma once

// People on the ground below a flight: cells of a population raster, and those that volumes touch.
//
// Example:
//   std::istringstream in("row,column,people,lon,lat,lon,lat,lon,lat,lon,lat\n"
//                         "0,0,12.5,8.5,47.4,8.501,47.4,8.501,47.401,8.5,47.401\n");
//   const traj::Population population = traj::read_population(in, "population.csv");
//   const traj::PopulationOnMap cells(population, {47.4, 8.5, 400});
//   assert(cells.exposed({}).people == 0);

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/geographic_frame.h"
#include "geom/shape/polygon.h"
#include "traj/submit/risk_volumes.h"

namespace traj {

// A cell of a raster that counts people. Its edges may bend by a thousandth of their length.
struct PopulationCell {
  std::size_t row = 0;
  std::size_t column = 0;
  std::optional<double> people = {};                // >= 0; absent: the raster does not say
  std::array<geom::GeodeticPlace, 4> corners = {};  // in turn; heights mean nothing
};

// All cells of some rows and some columns, row by row.
struct Population {
  std::vector<PopulationCell> cells;
};

// CSV with a header. Throws InputError(source, line, …) for a cell that is missing or comes twice,
// a number that is not finite, and people below 0.
Population read_population(std::istream& in, std::string_view source);
std::string population_csv(const Population& population);

struct Exposed {
  double people = 0;        // of all cells that are touched, each whole
  std::size_t unknown = 0;  // touched cells without a value in the raster
  bool inside = true;       // whether every place of the volumes is in one of the cells
};

// The cells over an origin.
class PopulationOnMap {
 public:
  PopulationOnMap(const Population& population, const geom::GeodeticOrigin& origin);

  // Of the cells that any of these buffers touches. Each counts once, and whole: the sum is no less
  // than the raster's people in the buffers. A cell counts as not touched only if a line in plan
  // keeps both apart after all that edges may bend.
  Exposed exposed(std::span<const RiskVolume> buffers) const;

 private:
  struct Cell {
    std::vector<geom::Vec2> ring;     // convex, counterclockwise
    std::vector<geom::Vec2> outline;  // the same, wider by what edges bend
    std::optional<double> people;
  };

  geom::GeodeticOrigin origin_;
  std::vector<Cell> cells_;
  std::vector<std::vector<geom::Vec2>> border_;  // edges of one cell alone, wider by what they bend
};

}  // namespace traj
