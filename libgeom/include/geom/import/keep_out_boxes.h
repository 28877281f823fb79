#pragma once

// No-fly volumes as boxes of a map.
//
// Example:
//   const std::string text =
//       R"({"type":"Polygon","coordinates":[[[0,0],[3,0],[3,3],[0,3],[0,0]]]})";
//   const geom::VolumeOptions local{.local = true};
//   const geom::KeepOut zones = geom::read_volumes(text, "zones.geojson", map.spec(), local);
//   const geom::BoxTable boxes = geom::keep_out_boxes(zones, "zones.geojson", map.spec(), local);
//   assert(boxes.boxes.size() == 1);

#include <optional>
#include <string>

#include "geom/import/keep_out.h"
#include "geom/map/box_map.h"
#include "geom/map/near_map.h"
#include "geom/shape/polygon.h"

namespace geom {

struct VolumeOptions {
  bool local = false;  // GeoJSON is in the map's own metres, not in longitude and latitude
  // Height of the map's z = 0 above the ellipsoid, metres, for volumes of ASTM F3548. Absent: what
  // the frame says.
  std::optional<double> zero_height;
  double slack = 0.5;  // metres that boxes may reach outside a volume
  bool far = false;    // whether volumes may lie anywhere
};

// GeoJSON (read_keep_out()) or volumes of ASTM F3548 (keep_out_of()), by what the text says.
// Throws InputError as these do, and UsageError for `local` beside F3548 and `zero_height` beside
// GeoJSON.
KeepOut read_volumes(const std::string& text, const std::string& source, const BoxMapSpec& spec,
                     const VolumeOptions& options);

// Boxes that hold the volumes, in their order, with their labels and times. Throws InputError where
// one lies elsewhere than the map (near_map.h) unless that is allowed, and where its sides would
// take more than 10,000 boxes.
BoxTable keep_out_boxes(const KeepOut& zones, const std::string& source, const BoxMapSpec& spec,
                        const VolumeOptions& options);

// Throws InputError where the outline does not lie near the map, unless `far`; `feature` for
// messages.
void require_near(const BoxMapSpec& spec, const DrawnRing& outline, bool far, std::uint64_t feature,
                  const std::string& source);

// Throws InputError where covering the polygon takes too many boxes: a sloping side is covered by a
// stair of boxes as high as the slack.
void refuse_long_stairs(const Polygon& polygon, double slack, const std::string& source,
                        std::uint64_t feature);

}  // namespace geom
