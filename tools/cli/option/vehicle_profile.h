#pragma once

// Vehicles as --vehicle names them.

#include <optional>
#include <string>

#include "geom/vehicle/vehicle.h"
#include "traj/flight/airframe.h"

namespace cli {

struct VehicleProfile {
  geom::Vehicle vehicle;
  traj::Airframe airframe;  // of a profile only
  std::optional<geom::Vec3>
      body;  // half sizes, m, that the box holds up to vehicle.limits[geom::Limit::tilt]
};

// "box:HX,HY,HZ" or "sphere:R", which hold every attitude and limit nothing; or a profile, by a
// built-in name or in a JSON file: docs/formats.md.
// Throws UsageError for a malformed word, geom::InputError for a bad file.
VehicleProfile parse_vehicle(const std::string& word);

}  // namespace cli
