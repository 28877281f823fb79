#pragma once

// Points in messages.

#include <fmt/format.h>

#include <string>

#include "geom/base/vec3.h"

namespace plan {

inline std::string shown(const geom::Vec3& p) {
  return fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

}  // namespace plan
