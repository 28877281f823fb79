#pragma once

// What the parts of judge() share.

#include <cmath>

#include "proof/check_place.h"

namespace traj {

inline constexpr double kFileSlack = 1e-3;  // relative, on limits

inline double across(const Vec3& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

// The first fault counts.
inline void refuse(CheckResult& result, Reason reason, const Largest& worst) {
  if (result.reason != Reason::none) return;
  result.ok = false;
  note(result, reason, worst);
}

}  // namespace traj
