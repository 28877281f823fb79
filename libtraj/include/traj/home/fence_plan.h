#pragma once

// Fences compiled for a mission and its returns: few corners, regions inside, tall boxes outside.
//
// Example:
//   traj::FenceTask task;
//   task.regions = {{{{0, 0, 60}, {80, 0, 60}}, {1, 1}}};  // a way home, with a metre of room
//   task.low = task.high = 60;
//   task.origin = {47.4, 8.5, 400};
//   const traj::CompiledFences made = traj::compile_fences(scene, task);
//   if (made.missing.empty()) std::cout << made.corners << " corners\n";

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/map/frame.h"
#include "geom/shape/polygon.h"
#include "traj/mission/firmware/autopilot.h"
#include "traj/mission/flown/fence.h"

namespace traj {

// The convex hull of a few points, in the map's axes, and metres around each place of it, along x
// and y, that must be within the fences too: the vehicle's half sizes and how far it may stray.
struct FencedRegion {
  std::vector<geom::Vec3> hull;
  geom::Vec2 room = geom::Vec2::Zero();
};

struct FenceTask {
  std::vector<FencedRegion> regions;  // at least one
  // m, of z: a box is tall if it, grown by the scene's vehicle and margin, meets these heights.
  double low = 0;
  double high = 0;
  std::size_t budget = 63;      // corners of all polygons
  geom::GeodeticOrigin origin;  // of the map's (0, 0, 0)
};

struct CompiledFences {
  // An inclusion, then exclusions; polygons alone, corners in whole 1e-7 degrees. Empty where
  // `missing` says why.
  std::vector<GeodeticFence> fences;
  std::size_t corners = 0;  // of the best fences that were found, also where these are too many
  // Tall boxes that no fence keeps out, ascending: regions pass over or under them, or nearer to
  // them than fences in whole 1e-7 degrees can be drawn.
  std::vector<std::size_t> open;
  std::string missing;  // empty: the fences are compiled, and proved
};

// Fences that hold all regions and keep out of all tall boxes but the open ones, proved by
// why_not_fenced() after rounding. Deterministic. Not the fewest corners that are possible.
//
// Boxes and bounds cut the plan into cells. The cells that regions meet are one area, whose rings
// lose corners one by one as long as what a ring sweeps over is free of regions and boxes.
CompiledFences compile_fences(const geom::CollisionScene& scene, const FenceTask& task);

// Says in words how fences break what compile_fences() promises; nothing if they keep it. Each
// region with its room is within every inclusion and out of every exclusion (check_fences), and
// each tall box that is not `open`, whole, is outside of an inclusion or inside of an exclusion.
// Nothing is sampled. Throws InputError(source, …) as fence_on_map().
std::optional<std::string> why_not_fenced(const geom::CollisionScene& scene, const FenceTask& task,
                                          std::span<const GeodeticFence> fences,
                                          std::span<const std::size_t> open,
                                          std::string_view source);

// Corners of a fence as autopilots count them: a circle is one.
std::size_t corners_of(std::span<const GeodeticFence> fences);

// Corners that all of the autopilots can store, in their usual builds. PX4: 64, and 63 before 1.15,
// where the first place has the count (MavlinkMissionManager::MAX_COUNT). ArduPilot: 70, which
// boards with the smallest storage of 16 KiB have (AC_PolyFence_loader::max_items: 84 on a
// Pixhawk).
std::size_t fence_budget(std::span<const Autopilot> autopilots);

}  // namespace traj
