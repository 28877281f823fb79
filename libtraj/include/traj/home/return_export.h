#pragma once

// Drone files with rally points, fences and a return height, read back and proved.
//
// Example:
//   traj::ReturnWishes wishes;
//   wishes.height = 60;
//   wishes.compiles_fences = true;
//   const traj::MissionExport made = traj::export_with_return(
//       scene, traj::ExportFlight{"q1", trajectory}, traj::kQgcPlan,
//       {.placement = {.origin = geom::GeodeticOrigin{47.4, 8.5, 400}}}, wishes);
//   std::cout << (made.written ? made.written->text : made.refusal);

#include <cstddef>
#include <optional>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/mission/export_mission.h"

namespace traj {

struct ReturnWishes {
  std::optional<double> height = {};       // m above home; else each autopilot's own
  std::vector<Vec3> rally = {};            // in the air, in the map's axes
  std::vector<GeodeticFence> fences = {};  // as they are
  bool compiles_fences = false;            // in place of these
  std::optional<std::size_t> budget = {};  // corners of fences; else fence_budget()
  bool params = false;                     // WrittenMission::params is written
  bool procedure = false;                  // and WrittenMission::procedure
  std::size_t off_nominal = 0;             // volumes for returns, at most; of volumes of airspace

  bool any() const;
};

// export_mission() with what the wishes say. Of missions: `refusal` says so where the return height
// is above the map's ceiling, a rally point is outside of the map, in an obstacle, without level
// ground as high as home's below it, or outside of a fence, where fences have more corners than the
// autopilots store, and where none can be compiled. Compiled fences hold the mission and each
// return that is proved without them and leaves 3 cm for them (prove_return), and keep out of the
// boxes that reach the return height. `warnings` say from which times no return is proved, and how
// many boxes are not fenced out. Of volumes of airspace: the off-nominal ones are added, and hold
// all returns (why_returns_not_held).
//
// Throws geom::UsageError as export_mission() does, for formats but kWpl, kQgcPlan and kVolume4d,
// and for parameters of several firmwares.
MissionExport export_with_return(const geom::CollisionScene& scene, const ExportFlight& flight,
                                 const MissionFormat& format, const ExportOptions& options,
                                 const ReturnWishes& wishes);

}  // namespace traj
