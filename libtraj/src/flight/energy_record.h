#pragma once

// The member "energy" of a vehicle's profile.

#include <optional>

#include "geom/text/json_fields.h"
#include "traj/flight/airframe.h"
#include "traj/flight/energy.h"

namespace traj {

// Nothing without that member. What it does not say of capacity and hovering follows from the
// airframe's battery and endurance. Throws InputError for a key that is not known, a value that
// cannot be, and where capacity or power are not said at all.
std::optional<Energy> parse_energy(const geom::JsonFields& fields, const Airframe& airframe);

}  // namespace traj
