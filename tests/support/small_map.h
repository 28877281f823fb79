#pragma once

// A map of a few boxes.

#include <utility>
#include <vector>

#include "support/random_city.h"

namespace support {

inline geom::BoxMap map_of(const geom::Aabb& bounds, std::vector<geom::Aabb> boxes) {
  return {{.bounds = bounds, .bounds_from = "option"}, table_of(std::move(boxes))};
}

}  // namespace support
