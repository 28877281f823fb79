#pragma once

// Heights over the ground that a vehicle keeps to, as boxes of a map below and above them.
//
// Example:
//   const geom::GroundModel ground = geom::GroundModel::flat(10);
//   const geom::BoxMapSpec spec{.bounds = {{0, 0, 0}, {50, 50, 300}}};
//   const geom::BoxTable sky = geom::ground_band_boxes({.high = 120}, ground, spec, "city.boxmap");
//   assert(sky.boxes.size() == 1 && sky.boxes[0].min.z() <= 130 && sky.boxes[0].min.z() > 129.9);

#include <optional>
#include <string>

#include "geom/map/box_map.h"
#include "geom/map/ground_model.h"

namespace geom {

struct GroundBand {
  std::optional<double> low;   // metres over the ground; absent: no limit
  std::optional<double> high;  // > low
  double step = 2;             // metres that a box may take from the band over sloping ground
  bool close_unknown = false;  // where the ground is not known, the map is closed
};

// Boxes within the bounds that hold every point which is less than `low` over the highest ground
// that may be below it, or more than `high` over the lowest: so a vehicle that meets none of them
// is within the band over the true ground, as far as the height model and its error tell. Labels
// say what they are. Throws InputError(source, …) where the ground is not known everywhere within
// the bounds, unless that is closed, for a frame that is not the ground's, and where more than
// 2,000,000 boxes would be needed.
BoxTable ground_band_boxes(const GroundBand& band, const GroundModel& ground,
                           const BoxMapSpec& spec, const std::string& source);

// Throws InputError(source, …) where the ground and the map must count heights from different
// zeros: all of the ground is above or below the bounds, or all that stands in the map is below the
// ground; and where the frame is not the ground's.
void require_same_zero(const GroundModel& ground, const BoxMap& map, const std::string& source);

}  // namespace geom
