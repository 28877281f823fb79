#pragma once

// Buildings as prisms, flat or under a roof, and prisms as boxes.
//
// Example:
//   geom::Footprint house;
//   house.polygon.outer = {{0, 0}, {8, 0}, {8, 6}, {0, 6}};
//   house.top = 9;
//   const geom::BoxTable boxes = geom::boxes_of({house}, 0.5, {});
//   assert(boxes.boxes.size() == 1);

#include <cstdint>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "geom/shape/polygon.h"

namespace geom {

// The volume over a polygon from one height up to another, or up to a surface (closed).
struct Footprint {
  Polygon polygon;
  double bottom = 0;  // metres, <= top
  double top = 0;
  std::uint64_t id = 0;         // of the feature; footprints of one feature follow each other
  bool likely_covered = false;  // a wall or floor that others of its feature probably hold already
  bool ground = false;          // of the Earth: solid however far down the map reaches
  // The height of each corner, those of `outer` first, then those of each hole: the top is the
  // surface that they span. No corner is above `top`. Empty: the top is flat.
  std::vector<double> heights;
  // The true sides may lie up to this many metres beside those of the polygon. Boxes hold the
  // polygon grown by it, and reach no further than the slack outside the polygon shrunk by it. For
  // flat tops only.
  double bulge = 0;
  std::uint32_t label = 0;  // of the feature: a number that its boxes get
};

// Boxes that contain every point of the footprints, none reaching further than `slack` metres
// (Euclidean) outside its own: see geom::cover and geom::cover_slope. A footprint that is likely
// covered, or stands upright, gives boxes only where it is not within its feature's other boxes. A
// bulge must be less than a third of the slack (InputError).
BoxTable boxes_of(const std::vector<Footprint>& footprints, double slack, const Execution& run);

// How far apart, in metres, two readings of the footprint's surface may be, since its corners lie
// in no plane: its boxes may reach that much further outside. 0 for upright or flat footprints.
double uneven_by(const Footprint& footprint, double slack);

}  // namespace geom
