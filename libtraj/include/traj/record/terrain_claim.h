#pragma once

// With which numbers a mission's heights above terrain became a band of heights.
//
// Example:
//   const traj::TerrainClaim claim{.model = "sha256:ab", .error = 9, .spacing = 100, .lag = 10};

#include <string>

namespace geom {
class JsonFields;
class JsonLine;
}  // namespace geom

namespace traj {

struct TerrainClaim {
  std::string model;   // the hash of the height model, or "flat"
  double error = 0;    // m that the autopilot's terrain may be off the true ground
  double spacing = 0;  // m between the posts of the autopilot's terrain
  double lag = 0;      // m that the vehicle may be behind the terrain
  double band = 0;     // m: the widest, from its lowest height to its highest
};

// The members of the claim.
void add(geom::JsonLine& line, const TerrainClaim& claim);
// Throws geom::InputError for a member that is missing or no such number.
TerrainClaim read_terrain_claim(const geom::JsonFields& fields);

}  // namespace traj
