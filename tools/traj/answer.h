#pragma once

// How what is solved for a path comes from a process of its own.

#include <string>
#include <string_view>

#include "traj/record/solved_record.h"

namespace solving {

// What a process answers, as text: the rung or status, the trajectory, and its corridor, a line
// each.
std::string to_text(const traj::SolvedRecord& solved, bool with_corridor);

struct Answer {
  std::string_view found;       // the rung or status
  std::string_view trajectory;  // a line
  std::string_view corridor;    // a line, or empty
};
Answer parse_answer(std::string_view text);  // views of it

}  // namespace solving
