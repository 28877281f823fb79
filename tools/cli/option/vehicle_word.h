#pragma once

// Vehicles as --vehicle names them.

#include <string>

#include "traj/flight/vehicle_profile.h"

namespace cli {

// "box:HX,HY,HZ" or "sphere:R", which hold every attitude and limit nothing; or a profile, by the
// name of one of data/vehicles or in a JSON file.
// Throws UsageError for a malformed word, geom::InputError for a bad file.
traj::VehicleProfile parse_vehicle(const std::string& word);

}  // namespace cli
