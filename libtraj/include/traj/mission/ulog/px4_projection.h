#pragma once

// Where on Earth PX4's local coordinates are.
//
// Example:
//   const geom::GeodeticPlace place = traj::px4_place({47.4, 8.5, 400}, 100, 0);  // 100 m north
//   assert(place.latitude > 47.4 && std::abs(place.longitude - 8.5) < 1e-9);

#include "geom/map/geographic_frame.h"

namespace traj {

// The place `north` and `east` metres from `reference` by PX4's local projection: azimuthal
// equidistant about the reference on a sphere of 6,371,000 m (J. P. Snyder, Map Projections - A
// Working Manual, 1987, section 25; PX4's lib/geo). Its metres are not those of the ellipsoid: they
// differ by up to 0.6 %, so that one who took them as they stand would be 6 m off at 1 km. Latitude
// and longitude are what the vehicle measured. The height is the reference's.
geom::GeodeticPlace px4_place(const geom::GeodeticPlace& reference, double north, double east);

}  // namespace traj
