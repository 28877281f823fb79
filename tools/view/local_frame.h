#pragma once

// Coordinates of the page: east, north, up in metres, from a point near the middle, so that single
// precision stays fine (16 um at 200 m, 60 um at 1 km).

#include <vector>

#include "geom/map/frame.h"

namespace view {

struct LocalFrame {
  geom::Vec3 origin = geom::Vec3::Zero();  // in ENU, whole metres
  geom::Axes axes = geom::Axes::enu;       // of the points that are given

  LocalFrame of(geom::Axes given) const { return {origin, given}; }
  geom::Vec3 at(const geom::Vec3& p) const { return geom::to_enu(axes, p) - origin; }
};

inline void append(std::vector<float>& out, const geom::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) out.push_back(static_cast<float>(v[axis]));
}

}  // namespace view
