#include "curve/continuity.h"

namespace traj {
namespace {

using Derivatives = std::array<Vec3, 7>;

// All of them at the start of a segment, or at its end.
Derivatives derivatives(const Segment& segment, bool at_end) {
  std::array<Vec3, kPoints> q = segment.point;
  Derivatives out;
  for (std::size_t d = 0; d < out.size(); ++d) {
    const std::size_t last = q.size() - 1 - d;
    out[d] = at_end ? q[last] : q[0];
    for (std::size_t k = 0; k < last; ++k) {
      q[k] = (q[k + 1] - q[k]) * (static_cast<double>(last) / segment.duration);
    }
  }
  return out;
}

}  // namespace

std::array<double, 7> largest_jumps(const Trajectory& trajectory) {
  std::array<double, 7> jumps{};
  for (std::size_t i = 1; i < trajectory.segments.size(); ++i) {
    const Derivatives before = derivatives(trajectory.segments[i - 1], true);
    const Derivatives after = derivatives(trajectory.segments[i], false);
    for (std::size_t d = 0; d < jumps.size(); ++d) {
      const double jump = (after[d] - before[d]).norm();
      if (!(jump <= jumps[d])) jumps[d] = jump;  // what is not a number is not passed by
    }
  }
  return jumps;
}

}  // namespace traj
