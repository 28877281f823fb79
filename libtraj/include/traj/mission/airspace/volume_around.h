#pragma once

// A volume of airspace around an upright prism, rounded outward.
//
// Example:
//   const std::vector<geom::Vec2> plan = {{0, 0}, {80, 0}, {80, 30}, {0, 30}};
//   geom::Volume4d volume = traj::volume_around({plan, 0, 60}, {47.4, 8.5, 400}, "q1");
//   assert(*volume.lower < 400 && *volume.upper > 460 && !volume.start);

#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/record/volume4d.h"
#include "geom/shape/polygon.h"

namespace traj {

// In east, north, up, metres; closed.
struct AirspacePrism {
  std::vector<geom::Vec2> outline;  // convex, counterclockwise
  double low = 0;
  double high = 0;
};

// Without times. Degrees are rounded to 1e-9, altitudes outward to centimetres, and the outline is
// wider by what its edges may bend and that rounds by (geom::outline_on_map). Throws InputError
// (source, …) as that does.
geom::Volume4d volume_around(const AirspacePrism& prism, const geom::GeodeticOrigin& origin,
                             std::string_view source);

// Whether a volume with both altitudes holds a prism, whole, however its edges are read: as
// straight in degrees, as geodesics or in metres. False may be said a micrometre early. Throws as
// above.
bool holds_prism(const geom::Volume4d& volume, const AirspacePrism& prism,
                 const geom::GeodeticOrigin& origin, std::string_view source);

}  // namespace traj
