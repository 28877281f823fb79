#pragma once

// Vehicle profiles: a vehicle's box, what may be done with it, and what it is made of.
//
// Example:
//   const auto tello = traj::vehicle_named("tello");
//   const geom::CollisionScene city(map, tello->vehicle, 0.2);
//   const traj::VehicleProfile own = traj::parse_vehicle_profile(
//       R"({"name":"quad","body":[0.2,0.2,0.1],"tilt_max_deg":30})", "quad.json");
//
// docs/formats.md describes the file.

#include <optional>
#include <string_view>
#include <vector>

#include "geom/shape/polygon.h"
#include "geom/vehicle/vehicle.h"
#include "traj/flight/airframe.h"
#include "traj/flight/energy.h"

namespace traj {

struct VehicleProfile {
  geom::Vehicle vehicle;
  Airframe airframe;               // of a profile only
  std::optional<geom::Vec3> body;  // half sizes, m, that the box holds up to vehicle's tilt limit
  // m across, and up or down: how wrong it may be about where it is
  std::optional<geom::Vec2> navigation = {};
  std::optional<Energy> energy = {};  // where it says so
};

// Throws geom::InputError(source, line, …) for a key that is not known: a limit under a name that
// nobody reads would not hold.
VehicleProfile parse_vehicle_profile(std::string_view json, std::string_view source);

// A profile of data/vehicles, which every program carries, by the file's name without ".json":
// "tello", or by one that the profile has in "also": "m3t". Nothing for another name.
std::optional<VehicleProfile> vehicle_named(std::string_view name);
std::vector<std::string_view> vehicle_names();  // in alphabetical order

}  // namespace traj
