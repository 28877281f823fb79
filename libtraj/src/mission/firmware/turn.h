#pragma once

// What a vehicle does at a point of its way.

#include <vector>

#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;

// It comes to rest, or passes, turning within the radius (m): the largest
// that it may have, and the least.
struct Turn {
  enum Kind { rest, pass } kind = rest;
  double radius = 0;
  double least = 0;
  double said = 0;              // the item's own radius; 0: it says none
  std::vector<Vec3> from = {};  // where it may come from straight, beside the leg
};

}  // namespace traj
