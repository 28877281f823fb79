#include "tracks.h"

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

using geom::Vec3;

constexpr double kStep = 0.05;     // seconds between the points of a curve
constexpr double kPathStep = 0.5;  // metres
constexpr double kMost = 20000;    // points or steps

double step_of(double extent, double step) { return std::max(step, extent / kMost); }

std::vector<Vec3> points_of(const traj::Trajectory& trajectory) {
  const double end = traj::duration(trajectory);
  const double count = std::max(1.0, std::ceil(end / step_of(end, kStep)));
  std::vector<Vec3> out;
  for (double k = 0; k <= count; ++k) {
    out.push_back(traj::evaluate(trajectory, end * (k / count)).position);
  }
  return out;
}

std::vector<Vec3> points_of(const traj::FlightLog& flight, geom::Axes axes) {
  std::vector<Vec3> out;
  for (const traj::FlightSample& s : flight.samples) {
    out.push_back(geom::to_enu(axes, s.position));
  }
  return out;
}

ClearanceTrack track_of(const traj::TrajectoryRecord& record, const geom::CollisionScene& scene) {
  const double step = step_of(traj::duration(record.trajectory), kStep);
  return {"trajectory " + record.id, traj::clearance_profile(scene, record.trajectory, step)};
}

ClearanceTrack track_of(const traj::FlightLog& flight, const geom::CollisionScene& scene) {
  std::vector<double> times;
  for (const traj::FlightSample& s : flight.samples) times.push_back(s.time);
  const auto points = points_of(flight, scene.map().spec().frame.axes);
  return {"flight " + flight.id, traj::clearance_profile(scene, points, times)};
}

ClearanceTrack track_of(const geom::PathRecord& path, const geom::CollisionScene& scene) {
  const double step = step_of(geom::length(path.points), kPathStep);
  return {"path " + path.id, traj::clearance_profile(scene, path.points, step)};
}

}  // namespace

std::vector<PlanTree> plan_trees(const cli::Contents& contents, geom::Axes axes) {
  std::vector<PlanTree> out;
  for (const auto& [record, source, line] : contents.trees) {
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

std::vector<PlanLine> plan_lines(const cli::Contents& contents, geom::Axes axes) {
  std::vector<PlanLine> out;
  const auto add = [&](const char* kind, const std::string& id,
                       const std::vector<geom::Vec3>& points, bool corners) {
    PlanLine line{kind, id, {}, corners};
    for (const geom::Vec3& p : points) line.points.push_back(geom::to_enu(axes, p));
    out.push_back(std::move(line));
  };
  for (const auto& [path, source, n] : contents.paths) add("path", path.id, path.points, true);
  for (const auto& [t, source, n] : contents.trajectories)
    add("trajectory", t.id, points_of(t.trajectory), false);
  for (const auto& [f, source, n] : contents.flights)
    add("flight", f.id, points_of(f, axes), false);
  return out;
}

Tracks tracks_of(const cli::Contents& contents, const geom::CollisionScene& scene) {
  Tracks out{{}, "time, s"};
  const auto add = [&](const auto& list) {
    for (const auto& [way, source, n] : list) {
      ClearanceTrack track = track_of(way, scene);
      if (!track.spans.empty()) out.list.push_back(std::move(track));
    }
  };
  add(contents.trajectories);
  add(contents.flights);
  if (!out.list.empty()) return out;
  out.x_label = "length along the path, m";
  add(contents.paths);
  return out;
}

geom::Provenance provenance_of(const cli::Contents& contents) {
  if (!contents.trajectories.empty()) return contents.trajectories[0].record.provenance;
  if (contents.flights.empty() && !contents.paths.empty())
    return contents.paths[0].record.provenance;
  return {};
}

}  // namespace plot
