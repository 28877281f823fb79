#pragma once

// Box maps as Gazebo worlds.
//
// Example:
//   std::ofstream out("city.sdf");
//   const std::size_t larger = geom::write_box_sdf(out, map);
//   assert(larger == 0);  // all boxes come back bit for bit

#include <cstddef>
#include <iosfwd>

#include "geom/map/box_map.h"

namespace geom {

// SDFormat 1.7, in east-north-up axes: a static model for each label, in it a link for each box
// with a collision and a visual, in the map's order; a plane as the floor, at the lower z of the
// bounds; <spherical_coordinates> where the map counts from its origin. <skyway:map> and
// <skyway:label>, which simulators pass over, keep what SDF has no words for: bounds, CRS, the
// origin of maps that count from elsewhere, and labels that may not be names of models.
//
// Returns how many boxes read_sdf_world() does not give back bit for bit. A few of the boxes that
// reach across 0 have a length that no double holds; they come back an ulp or so larger, never
// smaller. A map that was read from SDF has none of these unless bodies were turned.
std::size_t write_box_sdf(std::ostream& out, const BoxMap& map);

}  // namespace geom
