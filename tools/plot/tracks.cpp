#include "tracks.h"

#include "traj/figure/plan_lines.h"

namespace plot {

using traj::figure::plan_line;

namespace {

void add_height(traj::figure::HomeFlight& flight, const cli::Contents& contents) {
  for (const auto& [record, source, line] : contents.trajectories) {
    if (record.id != flight.id) continue;
    flight.height = traj::figure::height_over_time(record.trajectory);
    return;
  }
  for (const auto& [log, source, line] : contents.flights) {
    if (log.id != flight.id || !flight.height.empty()) continue;
    flight.height = traj::figure::height_over_time(log);
  }
}

}  // namespace

std::vector<geom::figure::PlanTree> plan_trees(const cli::Contents& contents, geom::Axes axes) {
  std::vector<geom::figure::PlanTree> out;
  for (const auto& [record, source, line] : contents.trees) {
    geom::figure::PlanTree tree;
    for (std::size_t i = 0; i < record.tree.points.size(); ++i) {
      if (record.tree.parent[i] == i) continue;
      tree.edges.push_back({geom::to_enu(axes, record.tree.points[record.tree.parent[i]]),
                            geom::to_enu(axes, record.tree.points[i])});
    }
    out.push_back(std::move(tree));
  }
  return out;
}

std::vector<geom::figure::PlanLine> plan_lines(const cli::Contents& contents, geom::Axes axes) {
  std::vector<geom::figure::PlanLine> out;
  for (const auto& read : contents.paths) out.push_back(plan_line(read.record, axes));
  for (const auto& read : contents.trajectories) out.push_back(plan_line(read.record, axes));
  for (const auto& read : contents.flights) out.push_back(plan_line(read.record));
  return out;
}

Tracks tracks_of(const cli::Contents& contents, const geom::CollisionScene& scene) {
  Tracks out{{}, "time, s"};
  const auto add = [&](const auto& list) {
    for (const auto& [way, source, n] : list) {
      traj::figure::ClearanceTrack track = traj::figure::clearance_track(scene, way);
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

std::vector<traj::figure::HomeFlight> home_flights(const cli::Contents& contents,
                                                   const std::optional<std::string>& id) {
  traj::figure::HomeFlights known(id);
  for (const auto& read : contents.reports) known.add(read.record);
  for (const auto& read : contents.contingencies) known.add(read.record);
  std::vector<traj::figure::HomeFlight> out = std::move(known).list();
  if (out.size() == 1) add_height(out.front(), contents);
  return out;
}

geom::Provenance provenance_of(const cli::Contents& contents) {
  if (!contents.trajectories.empty()) return contents.trajectories[0].record.provenance;
  if (contents.flights.empty() && !contents.paths.empty())
    return contents.paths[0].record.provenance;
  return {};
}

}  // namespace plot
