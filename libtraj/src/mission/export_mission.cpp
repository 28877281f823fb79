#include "traj/mission/export_mission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "geom/base/usage_error.h"
#include "mission/prove.h"
#include "mission/refusal.h"
#include "record/fault_verdict.h"
#include "traj/curve/to_enu.h"
#include "traj/curve/vertical_ends.h"
#include "traj/mission/dji/dji_mission.h"
#include "traj/mission/formats/mission_formats.h"
#include "traj/mission/named_aircraft.h"
#include "traj/mission/straight_legs.h"

namespace traj {
namespace {

using Warnings = std::vector<std::string>;

// What a file of straight legs does not command, and its check cannot hold.
void warn_of_unmeasured(const MissionTask& task, const CheckResult& result, Warnings& warnings) {
  std::vector<std::string> missing;
  for (const Limit limit : not_measured(result, task.limits)) {
    missing.push_back(spoken(kind_of(limit).quantity));
  }
  if (missing.empty()) return;
  warnings.push_back(fmt::format("{}: a {} file sets no limit on {}: set it in the vehicle itself",
                                 task.flight->id, task.format->format.word,
                                 fmt::join(missing, ", ")));
}

// What a file says of heights on Earth where only the map's z is known; empty: nothing.
std::string guessed_heights(const MissionTask& task) {
  const std::string_view word = task.format->format.word;
  if (task.format->heights == FileHeights::absolute) {
    return fmt::format("heights in a {} file take 0 m for it", word);
  }
  return fmt::format(
      "home's height above the sea in a {} file takes 0 m for it, and the other heights count from "
      "home",
      word);
}

void warn_of_guessed_heights(const MissionTask& task, Warnings& warnings) {
  if (knows_height(task) || task.format->heights == FileHeights::none) return;
  warnings.push_back(
      fmt::format("the map does not say how high above the ellipsoid its z = 0 is: {} (--origin "
                  "latitude,longitude,height says otherwise)",
                  guessed_heights(task)));
}

// Straight legs end in rests of their own, not in those of the record.
void warn_of_what_is_left_out(const MissionTask& task, Warnings& warnings) {
  const ExportFlight& flight = *task.flight;
  const std::string_view word = task.format->format.word;
  if (flight.time.any() && !task.options.says_when && !task.format->says_when) {
    warnings.push_back(
        fmt::format("{}: it begins {:.6g} s after the epoch; a {} file does not say when",
                    flight.id, flight.time.starts(), word));
  }
  if (!task.format->has_legs) return;
  if (flight.holds > 0) {
    warnings.push_back(
        fmt::format("{}: it stands still for {:.4g} s in all; a {} file has no such pauses, "
                    "so they are left out",
                    flight.id, flight.holds, word));
  }
  if (flight.has_velocities) {
    warnings.push_back(
        fmt::format("{}: a {} file has no velocities at points, so those of the path are left out",
                    flight.id, word));
  }
}

// Of a file that nobody checked: what it cannot say itself, and what it leaves out.
void warn_of_unchecked(const MissionTask& task, const WrittenMission& written, Warnings& warnings) {
  if (task.format == &kWpl || task.format == &kTello) {
    warnings.push_back(fmt::format(
        "a {} file has no room to say that nobody checked it: keep it apart from those that were",
        task.format->format.word));
  }
  const double missed = missed_end(task, read_again(task, written));
  if (missed <= kEndGap) return;
  warnings.push_back(
      fmt::format("{}: the file ends {:.3g} m from the flight's end", task.flight->id, missed));
}

// `result`: null where it was not checked.
Warnings warnings_of(const MissionTask& task, const WrittenMission& written,
                     const CheckResult* result) {
  Warnings warnings;
  if (result && !task.format->prove) warn_of_unmeasured(task, *result, warnings);
  if (task.format->warnings) {
    for (std::string& one : task.format->warnings(task, result)) {
      if (!one.empty()) warnings.push_back(std::move(one));
    }
  }
  warn_of_guessed_heights(task, warnings);
  warn_of_what_is_left_out(task, warnings);
  if (!written.note.empty()) warnings.push_back(task.flight->id + ": " + written.note);
  return warnings;
}

MissionTask task_of(const ExportFlight& flight, const geom::Frame& frame, const Limits& limits,
                    const MissionFormat& format, const ExportOptions& options) {
  MissionTask task;
  task.format = &format;
  task.options = options;
  task.flight = &flight;
  task.frame = frame;
  task.limits = limits;
  task.enu = to_enu(frame.axes, flight.trajectory);
  task.path = to_enu(frame.axes, flight.path);
  return task;
}

void require_slow_enough(const MissionTask& task) {
  const std::optional<double> most = speed_along_legs(task);
  const std::optional<double>& speed = task.options.speed;
  if (!speed || !most || *speed <= *most) return;
  throw geom::UsageError(
      fmt::format("--speed: expected at most {} m/s, which {} may fly in every direction, found {}",
                  *most, task.flight->id, *speed));
}

void set_ground(const geom::CollisionScene& scene, MissionTask& task) {
  const auto& segments = task.flight->trajectory.segments;
  task.ground =
      task.options.placement.ground.value_or(ground_below(scene, segments.front().point.front()));
  task.landing = ground_below(scene, segments.back().point.back());
}

// A mission of DJI names an aircraft, which the proof must be for.
std::string why_not_for(const geom::Vehicle& vehicle, const MissionTask& task) {
  if (task.format != &kDjiWpml) return "";
  return why_too_small(vehicle, vehicle_of(task.options.dji.aircraft));
}

}  // namespace

std::string why_unfit(const ExportFlight& flight, const MissionFormat& format) {
  if (format.unfit) return format.unfit(flight);
  if (flight.path.empty() || format.has_legs) return "";
  return fmt::format(
      "a {} file has times, and a path has none: make a trajectory of it "
      "(skyway-traj)",
      format.format.word);
}

MissionExport export_mission(const geom::CollisionScene& scene, const ExportFlight& flight,
                             const MissionFormat& format, const ExportOptions& options) {
  MissionTask task =
      task_of(flight, scene.map().spec().frame,
              geom::limits_that_hold({{}, flight.limits, scene.vehicle().limits}), format, options);
  if (std::string why = why_unfit(flight, format); !why.empty()) return {{}, std::move(why)};
  if (std::string why = why_not_for(scene.vehicle(), task); !why.empty()) {
    return {{}, std::move(why)};
  }
  if (!format.prove) set_ground(scene, task);
  MissionProof proof = write_proved(scene, task);
  if (!proof.refusal.empty()) return {{}, std::move(proof.refusal), proof.result};
  if (!proof.result.ok) return {{}, refusal(scene, task, proof.result), proof.result};
  Warnings warnings = warnings_of(task, proof.written, &proof.result);
  return {std::move(proof.written), {}, proof.result, std::move(warnings)};
}

MissionExport export_mission(const geom::CollisionScene& scene, const Trajectory& trajectory,
                             const MissionFormat& format, const ExportOptions& options) {
  return export_mission(scene, ExportFlight{"flight", trajectory}, format, options);
}

MissionExport export_unchecked(const ExportFlight& flight, const Limits& limits,
                               const geom::Frame& frame, const MissionFormat& format,
                               const ExportOptions& options) {
  MissionTask task = task_of(flight, frame, limits, format, options);
  task.checked = false;
  if (std::string why = why_unfit(flight, format); !why.empty()) return {{}, std::move(why)};
  if (!format.write) {
    throw geom::UsageError(fmt::format("{} are proved or not written at all", format.format.what));
  }
  require_slow_enough(task);
  task.ground = task.landing = options.placement.ground.value_or(0);
  WrittenMission written = format.write(
      task, task.path.empty() ? straight_legs(task.enu, options.tolerance) : task.path);
  Warnings warnings = warnings_of(task, written, nullptr);
  warn_of_unchecked(task, written, warnings);
  return {std::move(written), {}, {}, std::move(warnings)};
}

}  // namespace traj
