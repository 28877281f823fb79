#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/error.h"
#include "layers.h"
#include "traj/flight/moving_vehicle.h"

namespace view {
namespace {

constexpr double kFarthestCamera = 5;  // metres from the vehicle to its camera
constexpr double kLateness = 1e-6;     // seconds that a frame may be outside the motion

// As they stand in the page: solved trajectories, then flights.
std::vector<traj::MovingVehicle> motions_of(const cli::Contents& contents) {
  std::vector<traj::MovingVehicle> out;
  for (const auto& [record, source, line] : contents.trajectories) {
    if (record.status != traj::TrajectoryStatus::solved) continue;
    out.emplace_back(record.id, record.trajectory, axes_of(contents, record.provenance));
  }
  for (const auto& [flight, source, line] : contents.flights) out.emplace_back(flight);
  return out;
}

// Metres between camera and vehicle where they are furthest apart; infinite outside the motion's
// time.
double apart(const Frames& frames, const traj::MovingVehicle& motion) {
  double most = 0;
  for (const Frame& frame : frames.list) {
    const double t = frame.pose.time;
    if (t < motion.begin() - kLateness || t > motion.end() + kLateness) {
      return std::numeric_limits<double>::infinity();
    }
    most = std::max(most, (motion.pose(t).position - frame.pose.eye).norm());
  }
  return most;
}

}  // namespace

Json frames_layer(const Frames& frames, const cli::Contents& contents, Bundle& bundle) {
  const std::vector<traj::MovingVehicle> motions = motions_of(contents);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double most = apart(frames, motions[i]);
    if (most < least) {
      least = most;
      best = i;
    }
  }
  if (!(least <= kFarthestCamera)) {
    throw geom::InputError(
        frames.source,
        {.says = fmt::format(
             "expected frames along a trajectory or flight of this page, the camera within "
             "{} m of it at all times; found {}",
             kFarthestCamera,
             std::isfinite(least) ? fmt::format("the nearest {:.3g} m away", least)
                                  : "none that lasts so long")});
  }
  std::vector<float> times;
  std::vector<std::uint32_t> ends;
  std::string bytes;
  for (const Frame& frame : frames.list) {
    times.push_back(static_cast<float>(frame.pose.time - motions[best].begin()));
    bytes += frame.webp;
    ends.push_back(static_cast<std::uint32_t>(bytes.size()));
  }
  const std::span webp(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return {{"motion", best},
          {"width", frames.width},
          {"height", frames.height},
          {"time", bundle.add(std::span<const float>(times))},
          {"end", bundle.add(std::span<const std::uint32_t>(ends))},
          {"webp", bundle.add(webp)}};
}

}  // namespace view
