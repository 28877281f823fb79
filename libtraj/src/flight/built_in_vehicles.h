#pragma once

// The texts of data/vehicles, which the build puts into the library: one for each name of each.

#include <span>
#include <string_view>

namespace traj {

struct BuiltInVehicle {
  std::string_view name;
  std::string_view json;
};
std::span<const BuiltInVehicle> built_in_vehicles();  // by name

}  // namespace traj
