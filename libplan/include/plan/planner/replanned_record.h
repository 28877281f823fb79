#pragma once

// Path records of replanned paths, with the holds and velocities of the points that are kept.
//
// Example:
//   plan::Planner planner(scene);
//   const geom::PathRecord old{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const plan::ReplanResult result = plan::replan(scene, planner, old.points);
//   std::cout << to_json_line(plan::replanned_record(scene, old, result).record);

#include <cstddef>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "plan/planner/replan.h"

namespace plan {

struct ReplannedRecord {
  geom::PathRecord record;
  std::vector<std::size_t> lost;  // points of the old path whose hold or velocity could not be kept
};

// A hold stays where its point does. A velocity stays where the legs on both sides do (at the ends
// of the path the one), for a mended leg sets off in another direction.
ReplannedRecord replanned_record(const geom::CollisionScene& scene, const geom::PathRecord& old,
                                 const ReplanResult& result);

// The record of a path of another map, kept or mended over the scene of the planner. Its message
// says which holds and velocities were lost. A record that holds no path has no ends either:
// nothing is known of it on this map, so its status becomes `stopped`, and its message says what it
// was.
geom::PathRecord replanned(const geom::CollisionScene& scene, Planner& planner,
                           const geom::PathRecord& old, Quality quality = Quality::normal);
geom::PathRecord passed_on(const geom::PathRecord& record, const geom::BoxMap& map);

}  // namespace plan
