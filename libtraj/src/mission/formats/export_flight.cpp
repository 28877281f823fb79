#include "traj/mission/formats/export_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace traj {
namespace {

double stands_still(const Trajectory& trajectory) {
  double seconds = 0;
  for (const Segment& s : trajectory.segments) {
    const auto here = [&](const Vec3& p) { return p == s.point.front(); };
    if (std::all_of(s.point.begin(), s.point.end(), here)) seconds += s.duration;
  }
  return seconds;
}

Segment straight(const Vec3& from, const Vec3& to) {
  Segment segment{1, {}, {}};
  for (std::size_t i = 0; i < kPoints; ++i) {
    segment.point[i] = from + (to - from) * (static_cast<double>(i) / kDegree);
  }
  segment.point.back() = to;
  return segment;
}

std::string holds_none(std::string_view what, std::string_view status, const std::string& why) {
  return fmt::format("the record holds no {} (status {}){}", what, status,
                     why.empty() ? "" : ": " + why);
}

}  // namespace

ExportFlight export_flight(const TrajectoryRecord& record) {
  ExportFlight flight{record.id, record.trajectory};
  flight.limits = record.limits;
  flight.time = record.time;
  flight.holds = stands_still(flight.trajectory);
  return flight;
}

ExportFlight export_flight(const geom::PathRecord& record) {
  ExportFlight flight{record.id, {}};
  flight.time = record.time;
  flight.path = record.points;
  flight.path.erase(std::unique(flight.path.begin(), flight.path.end()), flight.path.end());
  for (std::size_t i = 1; i < flight.path.size(); ++i) {
    flight.trajectory.segments.push_back(straight(flight.path[i - 1], flight.path[i]));
  }
  if (flight.path.size() == 1) {
    flight.trajectory.segments.push_back(straight(flight.path[0], flight.path[0]));
  }
  flight.holds = std::accumulate(record.hold.begin(), record.hold.end(), 0.0);
  flight.has_velocities = std::any_of(record.velocity.begin(), record.velocity.end(),
                                      [](const auto& v) { return v && *v != Vec3::Zero(); });
  return flight;
}

std::string why_not_flown(const TrajectoryRecord& record) {
  if (record.status == TrajectoryStatus::solved) return {};
  return holds_none("trajectory", name(record.status), record.message);
}

std::string why_not_flown(const geom::PathRecord& record) {
  if (record.status == geom::PathStatus::found) return {};
  return holds_none("path", name(record.status), record.message);
}

}  // namespace traj
