#pragma once

// How far apart flights must be, and what they are before and after they fly.

#include <CLI/CLI.hpp>

#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace cli {

// --separation, --separation-box, --downwash and --parked. Both must outlive the app.
void add_spacing(CLI::App& app, traj::Spacing& spacing, traj::Parked& parked);

inline constexpr auto kSpacingOptions = {"--separation", "--separation-box", "--downwash",
                                         "--parked"};

}  // namespace cli
