#pragma once

// The ground of a map, from a height model.
//
// Example:
//   geom::gis::GroundOptions options{.cell = 5, .error = 1.5};
//   const geom::GroundModel ground =
//       geom::gis::ground_of_map("terrain.tif", map.spec(), options);
//   std::ofstream file("city.ground");
//   geom::write_ground(file, ground);

#include <string>

#include "geom/base/open_file.h"
#include "geom/gis/footprint_source.h"
#include "geom/map/box_map.h"
#include "geom/map/ground_model.h"

namespace geom::gis {

struct GroundOptions {
  double cell = 10;  // metres, of the map's grid; at most 100
  double error = 0;  // metres that the true ground may be above or below the model
  ReadOptions read = {};
  OpenFile open = open_file;
};

// Over the bounds of the map and a cell around them. Heights are the model's; the map's z is taken
// to count from the same zero. Cells that the model does not know all over are holes. Throws
// InputError where the model cannot be read, where neither map nor model say where on Earth they
// are but one does, and where the grid would have more than 25 million cells.
GroundModel ground_of_map(const std::string& path, const BoxMapSpec& spec,
                          const GroundOptions& options);

}  // namespace geom::gis
