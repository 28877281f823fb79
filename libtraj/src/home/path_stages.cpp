#include "traj/home/path_stages.h"

namespace traj {
namespace {

// At one velocity from `a` to `b`: control points evenly spaced.
Segment straight(const Vec3& a, const Vec3& b, double duration) {
  Segment out;
  out.duration = duration;
  for (int i = 0; i < kPoints; ++i) {
    out.point[static_cast<std::size_t>(i)] = i == kDegree ? b : Vec3(a + (b - a) * i / kDegree);
  }
  return out;
}

}  // namespace

std::vector<FlightStage> stages_of(const geom::PathRecord& path, double speed) {
  std::vector<FlightStage> out;
  double time = 0;
  const auto hold = [&](std::size_t i) {
    if (path.hold.empty() || path.hold[i] == 0) return;
    out.push_back({.from = time, .until = time + path.hold[i], .where = {path.points[i]}});
    time = out.back().until;
  };
  if (!path.points.empty()) hold(0);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vec3 leg = path.points[i] - path.points[i - 1];
    const double length = leg.norm();
    if (length > 0) {
      FlightStage stage{.from = time, .until = time + length / speed};
      stage.where = {path.points[i - 1], path.points[i]};
      stage.velocity = {leg * (speed / length)};
      stage.curve = straight(path.points[i - 1], path.points[i], length / speed);
      out.push_back(std::move(stage));
      time = out.back().until;
    }
    hold(i);
  }
  return out;
}

}  // namespace traj
