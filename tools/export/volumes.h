#pragma once

// A flight as the volumes of airspace that hold it, proved from the bytes that are written.

#include <optional>
#include <string>

#include "flight.h"
#include "geom/collision/collision.h"
#include "writer.h"

namespace exporting {

// Why none can be written for it: no trajectory, no start or no epoch. Empty: they can.
std::string no_volumes_for(const Flight& flight);

// The details of an operational intent (ASTM F3548) for a flight that is clear of the map and
// within `task.limits`: volumes that hold the vehicle with its margin and `task.buffer` at every
// instant, read back from the text. Nothing where the check or that proof refuses, which stderr
// says. Throws cli::UsageError where nobody knows the height of the map's z = 0.
std::optional<Written> write_volumes(const geom::CollisionScene& scene, const Flight& flight,
                                     const Task& task);

}  // namespace exporting
