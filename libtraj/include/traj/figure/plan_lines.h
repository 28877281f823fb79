#pragma once

// Paths, trajectories and flights as lines on the map of a figure.
//
// Example:
//   geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found};
//   record.points = path;
//   const std::vector lines{traj::figure::plan_line(record, map.spec().frame.axes)};
//   const std::string svg = geom::figure::plan_view(map, {}, lines);
//   assert(svg.find("path q1") != std::string::npos);

#include "geom/figure/plan_view.h"
#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/record/trajectory_record.h"

namespace traj::figure {

// `axes` are those of the record. A flight log is in ENU.
geom::figure::PlanLine plan_line(const geom::PathRecord& path, geom::Axes axes);
geom::figure::PlanLine plan_line(const TrajectoryRecord& record, geom::Axes axes);
geom::figure::PlanLine plan_line(const FlightLog& flight);

}  // namespace traj::figure
