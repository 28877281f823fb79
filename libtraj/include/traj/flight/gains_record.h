#pragma once

// Gains as JSON, in a vehicle's profile or in a file of their own.
//
// Example:
//   const traj::Gains gains = traj::nominal_gains(traj::Quadrotor{}, 0.6);
//   const geom::JsonFields fields(traj::to_json(gains), "gains.json", 0);
//   assert(traj::parse_gains(fields, traj::Gains{}).attitude == gains.attitude);

#include <string>

#include "traj/flight/gains.h"

namespace geom {
class JsonFields;
}

namespace traj {

// The key "gains" of these fields over `base`, which stands where a key is absent. Throws
// InputError where a gain is not a finite number >= 0, a clip or the tilt is not > 0, or a key is
// unknown.
Gains parse_gains(const geom::JsonFields& fields, const Gains& base);

// {"gains":{…}}, indented, with a final newline.
std::string to_json(const Gains& gains);

}  // namespace traj
