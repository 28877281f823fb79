#pragma once

// Volumes of ASTM F3548 that a map is to keep vehicles out of.
//
// Example:
//   geom::Volume4d zone{.lower = 400, .upper = 520};  // metres above the ellipsoid
//   zone.outline.centre = {47.4, 8.5, 0};
//   zone.outline.radius = 100;
//   const geom::Frame frame{.origin = geom::GeodeticOrigin{47.4, 8.5, 400}};
//   const geom::KeepOut cut = geom::keep_out_of({{zone}}, "zones.json", frame, {.ceiling = 300});
//   assert(cut.volumes[0].bottom < 0.1 && cut.volumes[0].top > 119.9);

#include <optional>
#include <span>
#include <string_view>

#include "geom/import/keep_out.h"
#include "geom/record/volume4d.h"

namespace geom {

struct VolumeKeepOutOptions {
  // Height of the map's z = 0 above the ellipsoid, metres. Absent: the height of the frame's
  // origin, unless that is 0. A height of 0 means that the height is unknown.
  std::optional<double> height;
  double floor = 0;    // metres in the map's z: where a volume that is open below starts
  double ceiling = 0;  // where one that is open above ends; >= floor
};

// One volume each, in the order of `volumes`, whose times are not looked at: in the map's
// coordinates, rounded outward, and `bulge` bounds by how much their edges may bend. Throws
// InputError(source, …) as outline_on_map() does, for a frame without origin, for an altitude where
// the height of z = 0 is not known, and for polygons with edges of more than 100 km.
KeepOut keep_out_of(std::span<const Volume4d> volumes, std::string_view source, const Frame& frame,
                    const VolumeKeepOutOptions& options);

// Whether the frame says how high z = 0 is above the ellipsoid: it has an origin, whose height is
// not 0.
bool knows_height(const Frame& frame);

}  // namespace geom
