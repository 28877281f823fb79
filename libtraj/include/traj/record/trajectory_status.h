#pragma once

// The result of making a trajectory of a path.
//
// Example:
//   assert(traj::name(traj::TrajectoryStatus::no_path) == "no_path");
//   assert(traj::reason_of(traj::TrajectoryStatus::solved) == traj::Reason::none);

#include <string_view>

#include "geom/text/words.h"
#include "traj/proof/reason.h"

namespace traj {

enum class TrajectoryStatus {
  solved,
  no_path,     // there was none to solve
  infeasible,  // no solver's answer was proved
  stopped      // somebody else's solver gave up; no tool here says so
};
inline constexpr geom::Words<TrajectoryStatus, 4> kTrajectoryStatusWords{{
    {TrajectoryStatus::solved, "solved"},
    {TrajectoryStatus::no_path, "no_path"},
    {TrajectoryStatus::infeasible, "infeasible"},
    {TrajectoryStatus::stopped, "stopped"},
}};
constexpr std::string_view name(TrajectoryStatus status) {
  return geom::word_of(kTrajectoryStatusWords, status);
}

// Why there is nothing to check in a record of this status.
constexpr Reason reason_of(TrajectoryStatus status) {
  return geom::value_of(kReasonWords, name(status)).value_or(Reason::none);
}

}  // namespace traj
