#pragma once

// The vehicle, margin and limits that hold where a run and a record both may name them.
//
// Example:
//   const geom::Provenance record = geom::provenance_of(scene);  // with a margin of 0.2 m
//   const geom::Room room = geom::agreed_room(record, {.vehicle = vehicle, .margin = 0.5},
//                                             geom::Differences::stricter_allowed, "q1", 0);
//   assert(room.margin == 0.5);

#include <optional>
#include <string>
#include <string_view>

#include "geom/record/record.h"
#include "geom/vehicle/vehicle.h"

namespace geom {

// What a run may do with what a record says.
enum class Differences {
  refused,           // nothing: both must say the same
  stricter_allowed,  // ask for more room; of the limits of both vehicles the stricter hold
  allowed,           // --override: the run alone decides
};

// The vehicle and the margin around the reference point, and the limits of the vehicle.
struct Room {
  Vehicle vehicle;
  double margin = 0;  // metres
};

// What the run names.
struct AskedRoom {
  std::optional<Vehicle> vehicle;
  std::optional<double> margin;
  double spare = 0;  // metres of the agreed margin that need not be kept
};

// Throws InputError(source, line, …) where the record asks for another vehicle, margin or limits of
// the vehicle than `differences` lets pass, or has less margin than may be spared; UsageError
// where neither says which vehicle. A vehicle without limits is one that nobody said them of, and
// takes the other's.
Room agreed_room(const Provenance& record, const AskedRoom& asked, Differences differences,
                 std::string_view source, std::size_t line);

// Whether the room is smaller, on any side, than what the record asks for.
bool smaller_than_asked(const Room& room, const Provenance& record);

// limits_that_hold() for a check. UsageError where a run that overrides records asks for more tilt
// than the vehicle's box holds.
Limits limits_to_check(const LimitSources& sources, const std::string& vehicle);

// Those to solve for: what is asked and what the vehicle may do. UsageError where more is asked
// than the vehicle may do, and where both say too little to solve for.
Limits limits_to_solve(const Limits& asked, const Vehicle& vehicle);

}  // namespace geom
