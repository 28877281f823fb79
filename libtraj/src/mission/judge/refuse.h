#pragma once

// What the parts of judge() share.

#include <cmath>

#include "traj/proof/check.h"

namespace traj {

inline constexpr double kFileSlack = 1e-3;  // relative, on limits

inline double across(const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

// The first fault counts.
inline void refuse(CheckResult& result, Reason reason, double time, const Vec3& place,
                   double worst) {
  if (result.reason != Reason::none) return;
  result.ok = false;
  result.reason = reason;
  result.time = time;
  result.place = place;
  result.worst = worst;
}

}  // namespace traj
