#pragma once

// Buildings as prisms, and prisms as boxes.

#include <cstdint>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "geom/shape/polygon.h"

namespace geom {

// The volume over a polygon between two heights (closed).
struct Footprint {
  Polygon polygon;
  double bottom = 0;  // metres, <= top
  double top = 0;
  std::uint64_t id = 0;         // of the feature; footprints of one feature follow each other
  bool likely_covered = false;  // a wall or floor that others of its feature probably hold already
  bool ground = false;          // of the Earth: solid however far down the map reaches
};

// Boxes that contain every point of the footprints, none reaching further than `slack` metres
// (Euclidean in plan) outside its own: see geom::cover. A footprint that is likely covered gives
// boxes only where its polygon is not within its feature's other boxes.
BoxTable boxes_of(const std::vector<Footprint>& footprints, double slack, const Execution& run);

}  // namespace geom
