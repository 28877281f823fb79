#pragma once

// What is known of the terrain or the surface that a vehicle follows.
//
// Example:
//   const geom::GroundModel ground = geom::GroundModel::flat(400);
//   const traj::TerrainRules rules{.ground = &ground, .error = 9};
//   assert(rules.ground->range({}).low == 400);

#include <optional>

#include "geom/map/ground_model.h"
#include "traj/record/terrain_claim.h"

namespace traj {

struct TerrainRules {
  const geom::GroundModel* ground = nullptr;  // along the axes of the map; must outlive its users
  geom::Axes axes = geom::Axes::enu;          // of the map
  // An autopilot with heights of its own has them at posts of a grid (TERRAIN_SPACING), and
  // interpolates between them. No file says them. What is claimed is that each post is within so
  // many metres (>= 0) of the true ground there, and the true ground is within the model.
  std::optional<double> error = {};
  // An aircraft that follows the surface as its sensors see it is claimed to be so high over the
  // true ground.
  std::optional<SurfaceBand> surface = {};
};

}  // namespace traj
