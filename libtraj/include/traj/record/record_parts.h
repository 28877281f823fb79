#pragma once

// Paths, trajectories, flights and corridors as triangles, to be shown beside the boxes of a map.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   std::vector<geom::MeshPart> parts = geom::box_parts(map);
//   parts.push_back(traj::path_part(record, map.spec().frame.axes, 0.3));
//   std::ofstream out("scene.glb", std::ios::binary);
//   geom::write_glb(out, parts);

#include "geom/mesh/mesh.h"
#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/record/corridor_record.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// Each is a line of this radius (metres) in a colour of its kind, those of Okabe and Ito. `axes`
// are those of the record. A curve has a point each 0.1 s, and at most 100,000.
geom::MeshPart path_part(const geom::PathRecord& path, geom::Axes axes, double radius);
geom::MeshPart trajectory_part(const TrajectoryRecord& record, geom::Axes axes, double radius);

// A flight log is in east, north and up, and has a row at least.
geom::MeshPart flight_part(const FlightLog& flight, double radius);

// The regions of a corridor, which let through what is behind them.
geom::MeshPart corridor_part(const CorridorShape& corridor, geom::Axes axes);

}  // namespace traj
