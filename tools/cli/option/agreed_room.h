#pragma once

// The vehicle and margin that hold where the options and a record both may name them.

#include <optional>
#include <string_view>

#include "geom/record/record.h"
#include "geom/vehicle/vehicle.h"

namespace cli {

// What the options may do with what a record says.
enum class Differences {
  refused,           // nothing: both must say the same
  stricter_allowed,  // ask for more room; of the limits of both vehicles the stricter hold
  allowed,           // --override: the options alone decide
};

// The room that is kept around the reference point, and what the vehicle in it may do.
struct Room {
  geom::Vehicle vehicle;
  double margin = 0;  // metres
};

// What the options name.
struct AskedRoom {
  std::optional<geom::Vehicle> vehicle;
  std::optional<double> margin;
  double spare = 0;  // metres of the agreed margin that need not be kept
};

// Throws geom::InputError(source, line, …) where the record asks for another vehicle, margin or
// limits of the vehicle than `differences` lets pass, or has less margin than may be spared;
// UsageError where neither says which vehicle.
// A vehicle without limits is one that nobody said them of, and takes the other's.
Room agreed_room(const geom::Provenance& record, const AskedRoom& asked, Differences differences,
                 std::string_view source, std::size_t line);

// Whether the room is smaller, on any side, than what the record asks for.
bool smaller_than_asked(const Room& room, const geom::Provenance& record);

}  // namespace cli
