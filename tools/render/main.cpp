// skyway-render: what a camera on the vehicle sees, and pictures of maps.

#include <fmt/format.h>

#include "cli/content/contents.h"
#include "cli/file/files.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/picture/film.h"
#include "options.h"
#include "shoot.h"
#include "traj/flight/moving_vehicle.h"

namespace {

constexpr double kSecondsBetween = 0.05;  // of the points of a way

std::vector<traj::MovingVehicle> motions_of(const cli::Contents& contents, geom::Axes axes) {
  std::vector<traj::MovingVehicle> out;
  for (const auto& [record, source, line] : contents.trajectories) {
    out.emplace_back(record.id, record.trajectory, axes);
  }
  for (const auto& [flight, source, line] : contents.flights) out.emplace_back(flight);
  return out;
}

// A flight is rather flown than the trajectory that it follows.
const traj::MovingVehicle* flown(const std::vector<traj::MovingVehicle>& motions,
                                 const render::Options& options) {
  const traj::MovingVehicle* best = nullptr;
  for (const traj::MovingVehicle& motion : motions) {
    if (!options.id.empty() && motion.id() != options.id) continue;
    if (!best || (motion.is_flight() && !best->is_flight())) best = &motion;
  }
  if (!best && !options.id.empty()) {
    throw cli::UsageError(fmt::format("--id: no solved trajectory or flight \"{}\"", options.id));
  }
  if (!best && (options.has_eye() || options.at || options.is_moving())) {
    if (options.inputs.empty()) {
      throw cli::UsageError(
          "nothing to fly along: give a trajectory or a flight log, or draw the map (--view plan "
          "or overview)");
    }
    throw geom::InputError(
        options.inputs[0],
        {.expected = "a solved trajectory or a flight to fly along", .found = "none"});
  }
  return best;
}

// Trees first, then paths, then what moves.
std::vector<geom::picture::Line> lines_of(const cli::Contents& contents,
                                          const std::vector<traj::MovingVehicle>& motions,
                                          geom::Axes axes) {
  std::vector<geom::picture::Line> out;
  for (const auto& [record, source, line] : contents.trees) {
    const plan::SearchTree& tree = record.tree;
    for (std::size_t i = 0; i < tree.points.size(); ++i) {
      if (tree.parent[i] == i) continue;
      out.push_back(geom::picture::tree_line(tree.tree[i],
                                             geom::to_enu(axes, tree.points[tree.parent[i]]),
                                             geom::to_enu(axes, tree.points[i])));
    }
  }
  std::size_t ways = 0;
  for (const auto& [path, source, line] : contents.paths) {
    out.push_back(geom::picture::way_line(ways++, path.id, {}));
    for (const geom::Vec3& p : path.points) out.back().points.push_back(geom::to_enu(axes, p));
  }
  for (const traj::MovingVehicle& motion : motions) {
    out.push_back(geom::picture::way_line(ways++, motion.id(), motion.way(kSecondsBetween)));
  }
  return out;
}

constexpr double kMostFrames = 1e7;
constexpr std::size_t kMostIds = 0xffffff;  // of three bytes; 0 is no box

render::Times times_of(const render::Options& options, const traj::MovingVehicle* motion) {
  if (options.at) {
    if (*options.at < motion->begin() || *options.at > motion->end()) {
      throw cli::UsageError(fmt::format("--at: expected a time from {} to {} s, found {}",
                                        motion->begin(), motion->end(), *options.at));
    }
    return {*options.at};
  }
  if (!options.is_moving()) return {std::nullopt};
  const double frames = (motion->end() - motion->begin()) * options.rate;
  if (frames > kMostFrames) {
    throw cli::UsageError(fmt::format("--rate: expected at most {:g} frames in all, found {:.0f}",
                                      kMostFrames, frames));
  }
  render::Times out;
  for (double k = 0; motion->begin() + k / options.rate <= motion->end(); ++k) {
    out.push_back(motion->begin() + k / options.rate);
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draw what a camera on the vehicle sees, and pictures of maps.", "skyway-render"};
  cli::Common common(app, true);
  render::Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.refuse_idle(app);
    options.settle();
    cli::at_most_one_stdin(options.map, options.inputs);
    const geom::BoxMap map =
        cli::open_map(options.map, geom::Verified::extents, common.execution("verify"));
    if (!options.ids.empty() && map.size() > kMostIds) {
      throw cli::UsageError(
          fmt::format("--ids: expected a map of at most {} boxes, found {}", kMostIds, map.size()));
    }
    cli::Contents contents = cli::read_contents(options.inputs);
    cli::require_same_map(contents, &map, options.metres);
    cli::warn_of_unsaid_maps(common, contents);
    cli::tell_left_out(common, "skyway-render", cli::drop_failed(contents));
    const geom::Axes axes = map.spec().frame.axes;
    const auto motions = motions_of(contents, axes);
    const traj::MovingVehicle* motion = flown(motions, options);
    const geom::Execution run = common.execution("frames");
    geom::picture::FilmContent content{lines_of(contents, motions, axes)};
    if (motion) content.vehicle = motion->filmed();
    const geom::picture::Film film(map, std::move(content), options.film, run);
    common.write_stats(render::shoot(film, times_of(options, motion), options, run));
    return cli::Exit::yes;
  });
}
