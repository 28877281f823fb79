#pragma once

// What was found for a path, as it is written and told.

#include <string>

#include "traj/record/solve_in_tube.h"

namespace solving {

struct Answer {
  std::string id;
  std::string found;       // the rung or status
  std::string why;         // there is no trajectory, in words; empty: there is one
  std::string rounds;      // how the search for a tube went, in words; empty: there were none
  std::string trajectory;  // a line
  std::string corridor;    // a line, or empty
  std::string report;      // of the tube, a line; empty: none was asked for
};

Answer answer_of(const traj::SolvedRecord& solved, bool with_corridor);
Answer answer_of(const traj::TubeSolved& solved, bool with_corridor, const geom::BoxMap& map);

}  // namespace solving
