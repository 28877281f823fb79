#pragma once

// The airframe in a vehicle profile.

#include "traj/flight/airframe.h"

namespace geom {
class JsonFields;
}

namespace traj {

// Throws InputError where a key that is there has a value that cannot be.
Airframe parse_airframe(const geom::JsonFields& fields);

}  // namespace traj
