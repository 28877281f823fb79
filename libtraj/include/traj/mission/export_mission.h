#pragma once

// Drone files that are proved: the bytes are read again as the drone will fly them, and judged.
//
// Example:
//   traj::ExportOptions options;
//   options.placement.origin = geom::GeodeticOrigin{47.4, 8.5, 400};
//   const traj::MissionFormat& format = *traj::mission_format_named("crazyflie");
//   const traj::MissionExport made = traj::export_mission(scene, trajectory, format, options);
//   std::cout << (made.written ? made.written->text : made.refusal);

#include <optional>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {

struct MissionExport {
  std::optional<WrittenMission> written;   // nothing where it was refused
  std::string refusal = {};                // why: place, reason and what to do; empty: it was not
  CheckResult result = {};                 // of what the bytes make the vehicle fly
  std::vector<std::string> warnings = {};  // what the user of the file should know
};

// Why the format cannot have the flight, as a path has no times; empty: it can.
std::string why_unfit(const ExportFlight& flight, const MissionFormat& format);

// The file of a flight over the scene's map, in the format. Limits: those of the flight and of the
// scene's vehicle. Straight legs are tried with the tolerance asked for or, where that fails, with
// points moved off what the legs would cut, and with ever finer legs; a path as it is, then with
// its points moved off by up to the tolerance. Refused is what would touch an obstacle, break a
// limit, or end over 2 cm from the flight's end ("end"). Throws geom::UsageError where `options`
// lack what the format needs, geom::InputError for a flight that is not near the origin.
MissionExport export_mission(const geom::CollisionScene& scene, const ExportFlight& flight,
                             const MissionFormat& format, const ExportOptions& options = {});
MissionExport export_mission(const geom::CollisionScene& scene, const Trajectory& trajectory,
                             const MissionFormat& format, const ExportOptions& options = {});

// The same without a map and without a proof, which the file says where the format has room.
// `limits` hold, `frame` is that of the flight. Throws geom::UsageError for a speed above them too:
// nothing judges the speed of each leg, so that it must suit legs in any direction.
MissionExport export_unchecked(const ExportFlight& flight, const Limits& limits,
                               const geom::Frame& frame, const MissionFormat& format,
                               const ExportOptions& options = {});

}  // namespace traj
