#include "traj/record/checked_hash.h"

#include <span>
#include <vector>

#include "geom/base/sha256.h"
#include "traj/curve/trajectory_hash.h"

namespace traj {
namespace {

std::string hash_of(std::vector<double> numbers) {
  for (double& number : numbers) number += 0.0;  // records write -0 as 0
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(numbers)));
  return sum.hex();
}

}  // namespace

std::string checked_hash(const TrajectoryRecord& record) {
  return trajectory_hash(record.trajectory);
}

std::string checked_hash(const geom::PathRecord& record) {
  std::vector<double> numbers{static_cast<double>(record.points.size())};
  for (const Vec3& p : record.points) numbers.insert(numbers.end(), p.begin(), p.end());
  return hash_of(std::move(numbers));
}

std::string checked_hash(const FlightLog& log) {
  std::vector<double> numbers{static_cast<double>(log.samples.size())};
  for (const FlightSample& sample : log.samples) {
    numbers.push_back(sample.time);
    numbers.insert(numbers.end(), sample.position.begin(), sample.position.end());
  }
  return hash_of(std::move(numbers));
}

}  // namespace traj
