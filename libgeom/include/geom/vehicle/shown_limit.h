#pragma once

// A limit in words.
//
// Example:
//   const geom::LimitKind& speed = geom::kind_of(geom::Limit::speed);
//   std::cout << geom::shown(speed, 12) << '\n';  // 12 m/s

#include <string>

#include "geom/vehicle/limits.h"

namespace geom {

// A value (SI) in the unit that options and messages use: "12 m/s", "35 degrees".
std::string shown(const LimitKind& kind, double value);

}  // namespace geom
