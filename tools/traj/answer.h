#pragma once

// What skyway-traj says of a path, and how that comes from a process of its own.

#include <string>
#include <string_view>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "options.h"
#include "traj/record/trajectory_record.h"

namespace solving {

struct Solved {
  traj::TrajectoryRecord record;
  traj::Corridor corridor = {};  // of the optimiser
};

Solved solve(const geom::CollisionScene& scene, const geom::PathRecord& path, const Task& task);

// Of a record that holds no path.
Solved without_path(const geom::PathRecord& path, const traj::Limits& limits);

// What a process answers, as text: the rung or status, the trajectory, and its corridor, a line
// each.
std::string to_text(const Solved& solved, bool with_corridor);

struct Answer {
  std::string_view found;       // the rung or status
  std::string_view trajectory;  // a line
  std::string_view corridor;    // a line, or empty
};
Answer parse_answer(std::string_view text);  // views of it

}  // namespace solving
