#pragma once

// The ground of a map, from a height model.
//
// Example:
//   geom::BoxMapSpec spec;
//   spec.bounds = {{-60, -60, 0}, {60, 60, 700}};
//   spec.frame.origin = geom::GeodeticOrigin{46.979985, 7.450026, 0};
//   const geom::GroundModel ground =
//       geom::gis::ground_of_map("town-ground.tif", spec, {.cell = 10, .error = 1.5});
//   assert(ground.range({{0, 0}, {50, 50}}).all_known);

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
