#pragma once

// A figure of how near the obstacles a vehicle comes, along paths or over time.
//
// Example:
//   geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found};
//   record.points = path;
//   const std::vector tracks{traj::figure::clearance_track(scene, record)};
//   const std::string svg = traj::figure::clearance(scene, tracks, "length along the path, m");
//   assert(svg.starts_with("<svg"));

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/proof/clearance.h"
#include "traj/record/trajectory_record.h"

namespace traj::figure {

struct ClearanceTrack {
  std::string id;  // "path q1"
  std::vector<ClearanceSpan> spans;
};

// The least distances in short parts: over time, s, of a trajectory or of a flight, which is in
// ENU; over the length, m, of a path. Without spans where it has no length in time or space, and on
// a map without obstacles.
ClearanceTrack clearance_track(const geom::CollisionScene& scene, const TrajectoryRecord& record);
ClearanceTrack clearance_track(const geom::CollisionScene& scene, const FlightLog& flight);
ClearanceTrack clearance_track(const geom::CollisionScene& scene, const geom::PathRecord& path);

// Of a flight in steps between some of its `rows` (ascending), from the first row of the log on: of
// the straight legs between all rows in a step the least. Empty on a map without obstacles.
std::vector<ClearanceSpan> clearance_of(const geom::CollisionScene& scene, const FlightLog& flight,
                                        std::span<const std::size_t> rows);

// An SVG of the least distances as steps, for the vehicle and the margin of the scene; those over
// 50 m are shown as that. The last metre (or twice the margin) has nearly half of the height; what
// is less than the margin, by more than a millimetre, is shaded and said. Each track has a span
// (precondition). `x_label` ends in its unit; `note` stands after the title.
std::string clearance(const geom::CollisionScene& scene, std::span<const ClearanceTrack> tracks,
                      std::string_view x_label, std::string_view note = "");

}  // namespace traj::figure
