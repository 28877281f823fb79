#pragma once

// Whether the map is clear with a tube around a trajectory, as a part of its report.
//
// Example:
//   const traj::TrajectoryRecord flight{.id = "q1", .trajectory = trajectory};
//   const traj::TubeRecord tube{.radius = {0.05}, .period = 100};
//   const traj::TubeReport report = traj::check_in_tube(scene, flight, tube, {});
//   if (!report.check.clear) std::cout << traj::name(report.check.reason) << '\n';

#include <optional>

#include "geom/collision/collision.h"
#include "traj/record/report_record.h"
#include "traj/record/trajectory_record.h"
#include "traj/record/tube_record.h"

namespace traj {

// check_tube() with the scene's vehicle and margin, at the tilt that the tube states: where that is
// above the limit of the vehicle, its half sizes grow as its `body` (half sizes, metres) needs.
// Throws InputError for such a tilt without a body.
TubeReport check_in_tube(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                         const TubeRecord& tube, const std::optional<Vec3>& body);

}  // namespace traj
