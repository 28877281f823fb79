#include "traj/proof/domain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace traj {
namespace {

// Written so that NaN is outside.
bool within(double value, double least, double most) { return value >= least && value <= most; }

bool is_coordinate(double value) { return std::abs(value) <= geom::kLargestCoordinate; }

// The first coordinate of the points, or value of the yaw, that is none.
std::optional<double> odd_coordinate(const Segment& segment) {
  for (const Vec3& p : segment.point) {
    for (const double value : p) {
      if (!is_coordinate(value)) return value;
    }
  }
  if (!segment.yaw) return std::nullopt;
  for (const double value : *segment.yaw) {
    if (!is_coordinate(value)) return value;
  }
  return std::nullopt;
}

std::optional<double> odd_limit(const Limits& limits) {
  for (const std::optional<double>& limit : limits.values) {
    if (limit && !within(*limit, kLeastLimit, kLargestLimit)) return *limit;
  }
  const std::optional<double>& tilt = limits[Limit::tilt];
  if (tilt && *tilt >= std::numbers::pi / 2) return *tilt;
  const std::optional<double>& thrust = limits[Limit::thrust];
  if (thrust && *thrust <= kGravity) return *thrust;
  return std::nullopt;
}

}  // namespace

std::optional<OutsideDomain> outside_domain(const Trajectory& trajectory, const Limits& limits) {
  if (trajectory.segments.empty()) return OutsideDomain{Reason::duration};
  double time = 0;
  for (const Segment& segment : trajectory.segments) {
    const double end = time + segment.duration;
    if (!within(segment.duration, kShortestSegment, kLongestTrajectory) ||
        end > kLongestTrajectory) {
      return OutsideDomain{Reason::duration, segment.duration, time};
    }
    if (const auto value = odd_coordinate(segment)) {
      return OutsideDomain{Reason::coordinates, *value, time};
    }
    time = end;
  }
  return outside_domain(limits);
}

std::optional<OutsideDomain> outside_domain(const Limits& limits) {
  if (const auto limit = odd_limit(limits)) return OutsideDomain{Reason::limits, *limit};
  return std::nullopt;
}

std::optional<OutsideDomain> outside_domain(std::span<const Vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double value : points[i]) {
      if (!is_coordinate(value))
        return OutsideDomain{Reason::coordinates, value, static_cast<double>(i)};
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> gap_in_yaw(const Trajectory& trajectory) {
  const auto& segments = trajectory.segments;
  const auto has = [](const Segment& s) { return s.yaw.has_value(); };
  if (std::none_of(segments.begin(), segments.end(), has)) return std::nullopt;
  const auto gap = std::find_if_not(segments.begin(), segments.end(), has);
  if (gap == segments.end()) return std::nullopt;
  return static_cast<std::size_t>(gap - segments.begin());
}

}  // namespace traj
