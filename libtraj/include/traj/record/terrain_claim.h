#pragma once

// With which numbers a mission's heights above terrain became a band of heights.
//
// Example:
//   const traj::TerrainClaim claim{.model = "sha256:ab", .error = 9, .spacing = 100, .lag = 10};
//   const traj::TerrainClaim seen{.model = "flat", .band = 30, .surface = {{40, 70}}};
//   assert(!claim.surface && seen.surface->high == 70);

#include <optional>
#include <string>

namespace geom {
class JsonFields;
class JsonLine;
}  // namespace geom

namespace traj {

// Metres over the ground between which an aircraft is, says its operator, where it follows the
// surface as its sensors see it.
struct SurfaceBand {
  double low = 0;
  double high = 0;

  bool sound() const { return 0 < low && low <= high && high <= kMost; }
  static constexpr double kMost = 1e4;
  bool operator==(const SurfaceBand&) const = default;
};
inline constexpr const char* kSurfaceBandKey = "surface_band";

struct TerrainClaim {
  std::string model;   // the hash of the height model, or "flat"
  double error = 0;    // m that the autopilot's terrain may be off the true ground
  double spacing = 0;  // m between the posts of the autopilot's terrain
  double lag = 0;      // m that the vehicle may be behind the terrain
  double band = 0;     // m: the widest, from its lowest height to its highest
  // Set if the aircraft follows the surface. Then error, spacing and lag are not used.
  std::optional<SurfaceBand> surface = {};
};

// The members of the claim.
void add(geom::JsonLine& line, const TerrainClaim& claim);
// Throws geom::InputError for a member that is missing or no such number, and for members of both
// kinds.
TerrainClaim read_terrain_claim(const geom::JsonFields& fields);

// The member kSurfaceBandKey: [low, high].
void add(geom::JsonLine& line, const SurfaceBand& band);
// Throws geom::InputError for what is no sound band.
SurfaceBand read_surface_band(const geom::JsonFields& fields);

}  // namespace traj
