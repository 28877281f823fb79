#pragma once

// The part of the proof that holds a trajectory against its limits.

#include <optional>

#include "traj/proof/check.h"

namespace traj {

// A limit, what a report calls it, and where its extreme goes.
struct LimitKind {
  const char* reason;
  std::optional<double> Limits::*limit;
  std::optional<Extreme> CheckResult::*extreme;
};
inline constexpr LimitKind kLimitKinds[] = {
    {"speed", &Limits::vmax, &CheckResult::speed},
    {"acceleration", &Limits::amax, &CheckResult::acceleration},
    {"jerk", &Limits::jmax, &CheckResult::jerk},
    {"tilt", &Limits::tilt, &CheckResult::tilt},
    {"horizontal_speed", &Limits::vmax_h, &CheckResult::horizontal_speed},
    {"vertical_speed", &Limits::vmax_v, &CheckResult::vertical_speed},
    {"thrust", &Limits::thrust, &CheckResult::thrust},
    {"body_rate", &Limits::body_rate, &CheckResult::body_rate},
    {"yaw_rate", &Limits::yaw_rate, &CheckResult::yaw_rate},
};

// Fills in the largest value of each limited quantity, and the reason of the first limit that is
// not shown to hold, unless there is a reason already.
void check_limits(const Trajectory& trajectory, const CheckOptions& options, CheckResult& result);

}  // namespace traj
