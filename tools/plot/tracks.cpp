#include "plot/tracks.h"

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

constexpr double kStep = 0.05;     // seconds between the points of a curve
constexpr double kPathStep = 0.5;  // metres
constexpr double kMostPoints = 20000;

std::vector<double> times(double begin, double end, double step) {
  const double count = std::clamp(std::ceil((end - begin) / step), 1.0, kMostPoints);
  std::vector<double> out;
  for (double k = 0; k <= count; ++k) out.push_back(begin + (end - begin) * (k / count));
  return out;
}

ClearanceTrack track_of(const traj::TrajectoryRecord& record) {
  ClearanceTrack track{
      "trajectory " + record.id, times(0, traj::duration(record.trajectory), kStep), {}};
  for (const double t : track.x) {
    track.points.push_back(traj::evaluate(record.trajectory, t).position);
  }
  return track;
}

ClearanceTrack track_of(const traj::FlightLog& flight, geom::Axes axes) {
  ClearanceTrack track{"flight " + flight.id, {}, {}};
  for (const traj::FlightSample& s : flight.samples) {
    track.x.push_back(s.time);
    track.points.push_back(geom::to_enu(axes, s.position));
  }
  return track;
}

ClearanceTrack track_of(const geom::PathRecord& path) {
  ClearanceTrack track{"path " + path.id, {}, geom::resample(path.points, kPathStep)};
  double along = 0;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    if (i > 0) along += (track.points[i] - track.points[i - 1]).norm();
    track.x.push_back(along);
  }
  return track;
}

}  // namespace

std::vector<PlanTree> plan_trees(const cli::Drawings& drawings, geom::Axes axes) {
  std::vector<PlanTree> out;
  for (const plan::SearchTreeRecord& record : drawings.trees) {
    PlanTree tree;
    for (std::size_t i = 0; i < record.tree.points.size(); ++i) {
      if (record.tree.parent[i] == i) continue;
      tree.edges.push_back({geom::to_enu(axes, record.tree.points[record.tree.parent[i]]),
                            geom::to_enu(axes, record.tree.points[i])});
    }
    out.push_back(std::move(tree));
  }
  return out;
}

std::vector<PlanLine> plan_lines(const cli::Drawings& drawings, geom::Axes axes) {
  std::vector<PlanLine> out;
  const auto add = [&](std::string label, const std::vector<geom::Vec3>& points, bool corners) {
    PlanLine line{std::move(label), {}, corners};
    for (const geom::Vec3& p : points) line.points.push_back(geom::to_enu(axes, p));
    out.push_back(std::move(line));
  };
  for (const auto& path : drawings.paths) add("path " + path.id, path.points, true);
  for (const auto& t : drawings.trajectories) add("trajectory " + t.id, track_of(t).points, false);
  for (const auto& f : drawings.flights) add("flight " + f.id, track_of(f, axes).points, false);
  return out;
}

Tracks tracks_of(const cli::Drawings& drawings, geom::Axes axes) {
  Tracks out{{}, "time, s", {}};
  for (const auto& t : drawings.trajectories) out.list.push_back(track_of(t));
  for (const auto& f : drawings.flights) out.list.push_back(track_of(f, axes));
  if (!drawings.trajectories.empty()) out.provenance = drawings.trajectories[0].provenance;
  if (!out.list.empty()) return out;
  out.x_label = "length along the path, m";
  for (const auto& p : drawings.paths) out.list.push_back(track_of(p));
  if (!drawings.paths.empty()) out.provenance = drawings.paths[0].provenance;
  return out;
}

}  // namespace plot
