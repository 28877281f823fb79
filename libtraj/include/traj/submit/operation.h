#pragma once

// Who flies what, as an operator says it for an authority: a small JSON file.
//
// Example:
//   const traj::Operation operation = traj::read_operation(
//       R"({"operator":{"name":"Ann Air","registration":"AUT123"},
//           "uas":{"model":"quad","serial":"7","class":"C3","dimension_m":0.7},
//           "lost_link":"returns and lands"})",
//       "operation.json");
//   assert(operation.uas.dimension == 0.7 && !operation.uas.endurance);
//
// docs/formats.md describes the file.

#include <optional>
#include <string>
#include <string_view>

#include "geom/base/vec3.h"
#include "geom/vehicle/vehicle.h"
#include "traj/flight/vehicle_profile.h"

namespace traj {

using geom::Vec3;

struct Operator {
  std::string name;
  std::string registration;  // as the state gave it
  std::string contact = {};  // may be empty
};

struct Uas {
  std::string manufacturer = {};  // may be empty
  std::string model;
  std::string serial;
  std::string uas_class;                 // "C0" to "C6", or "none"
  double dimension = 0;                  // m, > 0: the largest between two points of it
  std::optional<double> mass = {};       // kg at take-off
  std::optional<double> endurance = {};  // s in the air
};

struct Operation {
  Operator by;
  Uas uas;
  std::string lost_link;  // what happens if the link is lost
  std::string what = {};  // what the flights are for; may be empty
};

// Throws geom::InputError(source, …) that names the member which is missing, not known, empty, of
// another type or out of range.
Operation read_operation(std::string_view json, std::string_view source);

// Why no vehicle of this box is as large as an operation says: the box has no room for two points
// `dimension` m apart at every yaw, or a side of the body alone (half sizes; of a built-in vehicle
// its own) is longer, which would make ground risk buffers too narrow. Nothing if it may be.
std::optional<std::string> why_dimension_wrong(double dimension, const geom::Vehicle& vehicle,
                                               std::optional<Vec3> body = std::nullopt);
// Throws geom::InputError(source, …) with that of a profile, whose body is known.
void require_dimension(const Operation& operation, const VehicleProfile& profile,
                       std::string_view source);

}  // namespace traj
