#pragma once

// The rungs of the ladder of solvers: which of them made a trajectory.
//
// Example:
//   assert(traj::name(traj::Rung::stop_and_go) == "stop_and_go");

#include <string_view>

#include "geom/text/words.h"

namespace traj {

// In the order in which they are tried: a later one is a lower rung.
enum class Rung { closed, banded, ipopt, stop_and_go };
inline constexpr geom::Words<Rung, 4> kRungWords{{
    {Rung::closed, "closed"},
    {Rung::banded, "banded"},
    {Rung::ipopt, "ipopt"},
    {Rung::stop_and_go, "stop_and_go"},
}};
constexpr std::string_view name(Rung rung) { return geom::word_of(kRungWords, rung); }

}  // namespace traj
