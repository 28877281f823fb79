#include "traj/record/duration_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "curve/halves.h"
#include "proof/least_duration.h"

namespace traj {
namespace {

// Joints may miss each other by what the check allows (CheckOptions), which saves about as much.
constexpr double kRounding = 1e-6;

const Vec3& first(const TrajectoryRecord& record) {
  return record.trajectory.segments.front().point.front();
}
const Vec3& last(const TrajectoryRecord& record) {
  return record.trajectory.segments.back().point.back();
}

bool rests_at_ends(const Trajectory& trajectory) {
  if (trajectory.segments.empty()) return false;
  const auto& begin = trajectory.segments.front().point;
  const auto& end = trajectory.segments.back().point;
  return begin[0] == begin[1] && end[kDegree - 1] == end[kDegree];
}

// The curve is no longer than its control polygon, and no shorter than from end to end: halved
// until these are nearly the same.
double most_length(const std::array<Vec3, kPoints>& q, int halvings) {
  double polygon = 0;
  for (std::size_t i = 1; i < q.size(); ++i) polygon += (q[i] - q[i - 1]).norm();
  const double straight = (q.back() - q.front()).norm();
  if (halvings == 0 || polygon - straight <= 1e-7 * polygon) return polygon;
  const auto [first, second] = halves(q);
  return most_length(first, halvings - 1) + most_length(second, halvings - 1);
}

// With the steps between the segments.
double most_length(const Trajectory& trajectory) {
  constexpr int kHalvings = 12;
  double sum = 0;
  Vec3 before = trajectory.segments.front().point.front();
  for (const Segment& s : trajectory.segments) {
    sum += (s.point.front() - before).norm() + most_length(s.point, kHalvings);
    before = s.point.back();
  }
  return sum;
}

bool undercuts(const Trajectory& trajectory, const std::optional<double>& least) {
  return least && *least > duration(trajectory) * (1 + kRounding);
}

}  // namespace

std::optional<double> duration_bound(const TrajectoryRecord& record, const Limits& limits) {
  if (!record.bound || !rests_at_ends(record.trajectory)) return std::nullopt;
  return least_duration({first(record), last(record), *record.bound}, limits);
}

void add_bounds(const geom::PathRecord& path, TrajectoryRecord& record) {
  if (!path.bound || record.status != TrajectoryStatus::solved) return;
  if (geom::mismatch(path.provenance, record.provenance)) return;
  if (claims_too_much(path)) return;
  if (path.points.front() != first(record) || path.points.back() != last(record)) return;
  record.bound = path.bound;
  record.duration_bound = duration_bound(record, limits_of(record));
}

bool claims_too_much(const TrajectoryRecord& record) {
  if (record.trajectory.segments.empty()) return record.bound || record.duration_bound;
  if (record.bound && *record.bound > most_length(record.trajectory) * (1 + kRounding)) return true;
  const std::optional<double> follows = duration_bound(record, limits_of(record));
  if (undercuts(record.trajectory, follows)) return true;
  if (!record.duration_bound) return false;
  return !follows || *record.duration_bound > *follows ||
         undercuts(record.trajectory, record.duration_bound);
}

bool claims_too_much(const TrajectoryRecord& record, const Limits& limits) {
  return claims_too_much(record) ||
         (record.bound && undercuts(record.trajectory, duration_bound(record, limits)));
}

bool claims_too_much(const geom::PathRecord& path) {
  return path.bound && *path.bound > geom::length(path.points) * (1 + kRounding);
}

std::optional<double> duration_gap(const TrajectoryRecord& record) {
  const std::optional<double> least = duration_bound(record, limits_of(record));
  if (!least || claims_too_much(record)) return std::nullopt;
  return duration(record.trajectory) / *least - 1;
}

std::string slower_words(double gap) {
  const double percent = std::max(0.0, 100 * gap);
  const double tenths = std::ceil(percent * 10);
  return fmt::format("at most {:.1f} % slower than any", tenths / 10);
}

}  // namespace traj
