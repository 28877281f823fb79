#pragma once

// How what is solved for a path comes from a process of its own.

#include <string>
#include <string_view>

#include "traj/record/solve_in_tube.h"

namespace solving {

// What a process answers, as text: the rung or status, why there is no tube, how the search for one
// went, the report of the tube, the trajectory and its corridor, a line each.
std::string to_text(const traj::SolvedRecord& solved, bool with_corridor);
std::string to_text(const traj::TubeSolved& solved, bool with_corridor, const geom::BoxMap& map);

struct Answer {
  std::string_view found;       // the rung or status
  std::string_view why;         // in words; empty where there is a tube or none was asked for
  std::string_view rounds;      // in words; empty where there were none
  std::string_view report;      // a line, or empty
  std::string_view trajectory;  // a line
  std::string_view corridor;    // a line, or empty
};
Answer parse_answer(std::string_view text);  // views of it

}  // namespace solving
