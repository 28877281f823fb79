#pragma once

// What is known of the terrain that an autopilot follows.
//
// Example:
//   const geom::GroundModel ground = geom::GroundModel::flat(400);
//   const traj::TerrainRules rules{.ground = &ground, .error = 9};
//   assert(rules.ground->range({}).low == 400);

#include "geom/map/ground_model.h"

namespace traj {

// The autopilot has heights of its own, at posts of a grid (TERRAIN_SPACING), and interpolates
// between them. No file says them. What is claimed is that each post is within `error` metres of
// the true ground there, and the true ground is within the model.
struct TerrainRules {
  const geom::GroundModel* ground = nullptr;  // along the axes of the map; must outlive its users
  geom::Axes axes = geom::Axes::enu;          // of the map
  double error = 0;                           // m, >= 0
};

}  // namespace traj
