#pragma once

// Whether the map is clear with a tube around a trajectory, as a part of its report.
//
// Example:
//   const traj::TubeRecord tube{.radius = {0.05}, .period = 100};
//   const traj::TubeReport report = traj::check_in_tube(scene, "q1", trajectory, tube, {});
//   if (!report.check.clear) std::cout << traj::name(report.check.reason) << '\n';

#include <optional>

#include "geom/collision/collision.h"
#include "traj/record/report_record.h"
#include "traj/record/tube_reports.h"

namespace traj {

// check_tube() with the scene's vehicle and margin, at the tilt that the tube states: where that is
// above the limit of the vehicle, its half sizes grow as its `body` (half sizes, metres) needs.
// Throws InputError for such a tilt without a body.
TubeReport check_in_tube(const geom::CollisionScene& scene, std::string_view id,
                         const Trajectory& trajectory, const TubeRecord& tube,
                         const std::optional<Vec3>& body);

// The proved tube of a trajectory, as the place that volumes of airspace are to hold, held against
// the scene's map. Throws InputError as TubeReports::require_tube(), for statistics, and for a tilt
// that the half sizes do not hold.
TubeReport check_as_geography(const geom::CollisionScene& scene, std::string_view id,
                              const Trajectory& trajectory, const TubeReports& tubes);

// Half sizes, in metres, that hold such a vehicle around the trajectory.
Vec3 geography_half(const geom::Vehicle& vehicle, const TubeReport& tube);

}  // namespace traj
