#include "traj/curve/trajectory_hash.h"

#include <vector>

#include "geom/base/sha256.h"

namespace traj {

std::string trajectory_hash(const Trajectory& trajectory) {
  std::vector<double> numbers{static_cast<double>(trajectory.segments.size())};
  for (const Segment& segment : trajectory.segments) {
    numbers.push_back(segment.duration);
    for (const Vec3& p : segment.point) numbers.insert(numbers.end(), p.begin(), p.end());
    numbers.push_back(segment.yaw ? kPoints : 0);
    if (segment.yaw) numbers.insert(numbers.end(), segment.yaw->begin(), segment.yaw->end());
  }
  for (double& number : numbers) number += 0.0;  // records write -0 as 0
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(numbers)));
  return sum.hex();
}

}  // namespace traj
