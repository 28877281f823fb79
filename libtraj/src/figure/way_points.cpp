#include "way_points.h"

#include <algorithm>
#include <cmath>

namespace traj::figure {
namespace {

constexpr double kMost = 20000;  // points or steps

}  // namespace

double step_of(double extent, double step) { return std::max(step, extent / kMost); }

std::vector<Vec3> points_of(const Trajectory& trajectory) {
  const double end = duration(trajectory);
  const double count = std::max(1.0, std::ceil(end / step_of(end, kSecondsBetween)));
  std::vector<Vec3> out;
  for (double k = 0; k <= count; ++k) {
    out.push_back(evaluate(trajectory, end * (k / count)).position);
  }
  return out;
}

}  // namespace traj::figure
