#include "exporter.h"

#include <fmt/format.h>

#include <utility>

#include "cli/file/files.h"
#include "prove.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/straight_legs.h"
#include "volumes.h"

namespace exporting {
namespace {

void warn_of_memory(const cli::Common& common, const Task& task) {
  const traj::CrazyflieMemory memory = traj::crazyflie_memory(task.enu);
  if (memory.fits) return;
  common.warn(fmt::format(
      "{}: {} segments; a Crazyflie's memory holds {}{}", task.id, task.enu.segments.size(),
      traj::kCrazyflieSegments,
      memory.compressed_fits
          ? fmt::format(" (compressed they take {} of its 4096 bytes)", memory.compressed_bytes)
          : ", nor do they fit compressed"));
}

// The firmware's default controller follows positions alone, and no faster than 1.1 m/s along an
// axis (position_controller_pid.c); flown through it, faster files fell metres behind their times
// and cut across their curves (docs/firmware.md).
void warn_of_controller(const cli::Common& common, const Task& task,
                        const traj::CheckResult& result) {
  constexpr double kFollowed = 1;  // m/s
  const auto& speed = result.largest[traj::Limit::speed];
  if (task.format != "crazyflie" || !speed || speed->value <= kFollowed) return;
  common.warn(fmt::format(
      "{}: it flies {:.2g} m/s, and a Crazyflie's default controller (PID) follows no more than 1: "
      "set stabilizer.controller to 2 (Mellinger), or solve it with --vmax 1",
      task.id, speed->value));
}

// Straight legs end in rests of their own, not in those of the record. `says_when`: a file beside
// it does.
void warn_of_what_is_left_out(const cli::Common& common, const Task& task, const Flight& flight,
                              bool says_when) {
  if (flight.time.any() && !says_when) {
    common.warn(fmt::format("{}: it begins {:.6g} s after the epoch; a {} file does not say when",
                            task.id, flight.time.starts(), task.format));
  }
  if (!has_legs(task.format)) return;
  if (flight.holds > 0) {
    common.warn(
        fmt::format("{}: it stands still for {:.4g} s in all; a {} file has no such pauses, "
                    "so they are left out",
                    task.id, flight.holds, task.format));
  }
  if (flight.has_velocities) {
    common.warn(
        fmt::format("{}: a {} file has no velocities at points, so those of the path are left out",
                    task.id, task.format));
  }
}

// What a file says of heights on Earth where only the map's z is known; empty: nothing.
std::string guessed_heights(const Task& task) {
  if (knows_height(task)) return "";
  if (task.format == "kml" || task.format == "geojson" || task.format == "dji-wpml") {
    return fmt::format("heights in a {} file take 0 m for it", task.format);
  }
  if (task.format != "wpl" && task.format != "qgc-plan") return "";
  return fmt::format(
      "home's height above the sea in a {} file takes 0 m for it, and the other heights count from "
      "home",
      task.format);
}

void set_ground(const geom::CollisionScene& scene, const Flight& flight, Task& task) {
  const auto& segments = flight.trajectory.segments;
  task.ground =
      task.placement.ground.value_or(traj::ground_below(scene, segments.front().point.front()));
  task.landing = traj::ground_below(scene, segments.back().point.back());
}

// Without a map nothing judges the speed of each leg, so that it must suit legs in any direction.
void require_slow_enough(const Task& task) {
  const std::optional<double> most = speed_limit(task.limits);
  if (!task.speed || !most || *task.speed <= *most) return;
  throw cli::UsageError(
      fmt::format("--speed: expected at most {} m/s, which {} may fly in every direction, found {}",
                  *most, task.id, *task.speed));
}

void set_way(const Flight& flight, geom::Axes axes, Task& task) {
  task.enu = traj::to_enu(axes, flight.trajectory);
  task.path = traj::to_enu(axes, flight.path);
}

Written write_unchecked(const Options& options, const Flight& flight, Task& task) {
  task.limits = flight.limits;
  const auto asked = options.vehicle.asked(options.vehicle.profile());
  if (asked.vehicle || flight.provenance.vehicle) {
    const auto room =
        geom::agreed_room(flight.provenance, asked, geom::Differences::refused, options.input(), 0);
    task.limits = geom::limits_that_hold({{}, flight.limits, room.vehicle.limits});
  }
  require_slow_enough(task);
  task.frame.axes = flight.provenance.frame.value_or(geom::Axes::enu);
  task.ground = task.landing = task.placement.ground.value_or(0);
  set_way(flight, task.frame.axes, task);
  return write(task, task.path.empty() ? traj::straight_legs(task.enu, task.tolerance) : task.path);
}

// What a file of straight legs does not command, and its check cannot hold.
void warn_of_unmeasured(const cli::Common& common, const Task& task,
                        const traj::CheckResult& result) {
  std::vector<std::string> missing;
  for (const traj::Limit limit : traj::not_measured(result, task.limits)) {
    missing.push_back(in_words(traj::kind_of(limit).quantity));
  }
  if (missing.empty()) return;
  common.warn(fmt::format("{}: a {} file sets no limit on {}: set it in the vehicle itself",
                          task.id, task.format, fmt::join(missing, ", ")));
}

}  // namespace

Exporter::Exporter(const cli::Common& common, const Options& options, Task task)
    : common_(common), options_(options), task_(std::move(task)) {
  if (options.unchecked) return;
  scenes_.emplace(cli::open_map(options.files[0], geom::Verified::contents), options.vehicle,
                  cli::Scenes::Differences::refused);
}

Exporter::Export Exporter::make(const Flight& flight) {
  Export made{task_, {}};
  made.task.id = flight.id;
  const std::string missing = flight.missing.empty() ? not_for(flight) : flight.missing;
  if (!missing.empty()) {
    cli::complain("skyway-export", fmt::format("{}: refused: {}", flight.id, missing));
    return made;
  }
  made.written = options_.unchecked ? write_unchecked(options_, flight, made.task)
                                    : write_checked(flight, made.task);
  if (!made.written) return made;
  if (made.task.format == "crazyflie") warn_of_memory(common_, made.task);
  const std::string guessed = guessed_heights(made.task);
  if (!guessed.empty() && !std::exchange(told_of_heights_, true)) {
    common_.warn(
        fmt::format("the map does not say how high above the ellipsoid its z = 0 is: {} (--origin "
                    "latitude,longitude,height says otherwise)",
                    guessed));
  }
  const bool says_when = !options_.show.empty() || made.task.format == "volume4d";
  if (made.task.format == "setpoints" && !made.task.autopilot.tracking) {
    common_.warn(flight.id +
                 ": a setpoints file is proved for a vehicle that is where its setpoint "
                 "is; PX4 1.17 was up to 0.73 m away: --tracking H,V allows for that");
  }
  warn_of_what_is_left_out(common_, made.task, flight, says_when);
  if (!made.written->note.empty()) common_.warn(flight.id + ": " + made.written->note);
  return made;
}

// Why the format cannot have it, or nothing.
std::string Exporter::not_for(const Flight& flight) const {
  if (task_.format == "volume4d") return no_volumes_for(flight);
  if (flight.path.empty() || has_legs(task_.format)) return "";
  return fmt::format(
      "a {} file has times, and a path has none: make a trajectory of it "
      "(skyway-traj)",
      task_.format);
}

std::optional<Written> Exporter::write_checked(const Flight& flight, Task& task) {
  const auto& scene = scene_for(flight);
  task.limits = geom::limits_that_hold({{}, flight.limits, scene.vehicle().limits});
  task.frame = scene.map().spec().frame;
  options_.metres.check_input(task.frame, flight.trajectory, flight.id, 0);
  set_way(flight, task.frame.axes, task);
  if (task.format == "volume4d") return write_volumes(scene, flight, task);
  set_ground(scene, flight, task);
  auto [written, result] = write_proved(scene, task);
  if (result.ok) {
    warn_of_unmeasured(common_, task, result);
    warn_of_controller(common_, task, result);
    return std::move(written);
  }
  cli::complain("skyway-export", refusal(scene, task, result));
  return std::nullopt;
}

}  // namespace exporting
