#include "checker.h"

#include <fmt/format.h>

#include "cli/run.h"
#include "geom/record/agreed_room.h"
#include "geom/record/start_on_map.h"
#include "geom/text/json_fields.h"
#include "traj/mission/judge/judge.h"
#include "traj/proof/check.h"
#include "traj/proof/clearance.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/record/trajectory_record.h"

namespace checking {
namespace {

// The scene says only what vehicle it is for; the exact check looks at the map itself.
traj::ExactTask exact_task(const geom::CollisionScene& scene, const traj::Limits& limits,
                           const std::optional<double>& start = {}, bool stands = false) {
  return {scene.map(), scene.vehicle(), scene.margin(), limits, start, stands};
}

// Only --override allows it.
bool has_less_room(const geom::CollisionScene& scene, const geom::Provenance& record) {
  return geom::smaller_than_asked({scene.vehicle(), scene.margin()}, record);
}

// How the corners of a mission were taken; empty where it has none.
std::string corner_note(const traj::FlownMission* mission) {
  if (!mission || mission->corners == 0) return {};
  const traj::FlownMission& flown = *mission;
  const std::string where =
      fmt::format("{} waypoint{}", flown.corners, flown.corners == 1 ? "" : "s");
  if (flown.acceptance == 0) {
    return fmt::format(
        "the vehicle does not stop at {}: as --acceptance 0 says, it is taken to go "
        "to each before it turns",
        where);
  }
  return fmt::format(
      "the vehicle does not stop at {}: corners were looked at within {:.3g} m "
      "(--acceptance says otherwise)",
      where, flown.acceptance);
}

// Which drone files the exact check takes.
void require_exact(const traj::FlownLegs* legs, const traj::FlownMission* mission) {
  if (!legs) throw cli::UsageError("--exact takes paths and records, not files of trajectories");
  if (!mission || (mission->sweeps.empty() && mission->fences.empty())) return;
  throw cli::UsageError(
      "--exact takes straight legs: this mission has corners, curves or fences as well; check it "
      "without --exact");
}

// Of a collision while it stands on its pads.
std::string standing_detail(const traj::CheckResult& result) {
  if (result.reason != traj::Reason::collision) return {};
  if (result.time < 0) return "where it stands before it begins";
  return result.time > result.duration ? "where it stands after its end" : "";
}

// What is in the way of a take-off.
std::string takeoff_detail(const geom::CollisionScene& scene, const traj::CheckResult& result) {
  if (result.reason != traj::Reason::takeoff) return {};
  return fmt::format(
      "the flight begins {:.3g} m above the ground that it takes off from, and the vehicle reaches "
      "{:.3g} m below its reference point: it would begin inside the ground",
      result.worst, scene.half().z());
}

}  // namespace

traj::Limits Checker::limits_for(const traj::Limits& record, const geom::Vehicle& vehicle) const {
  return geom::limits_to_check({rules_.limits, record, vehicle.limits, rules_.override_record},
                               vehicle.name);
}

// The limits that --override loosens.
std::vector<std::string> Checker::loosened(const traj::TrajectoryRecord& record,
                                           const geom::Vehicle& vehicle,
                                           const traj::Limits& held) const {
  const geom::Limits strict =
      geom::limits_that_hold({rules_.limits, traj::limits_of(record), vehicle.limits});
  std::vector<std::string> out;
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    if (held[kind.limit] != strict[kind.limit]) out.emplace_back(kind.name);
  }
  return out;
}

// A limit that an option asks for is held or refused. One that only the vehicle's profile has, and
// that nothing in a path, a mission or a trajectory without yaw commands, is the vehicle's own to
// keep; the report names it.
void Checker::refuse_unmeasured(const geom::Vec3& place, traj::ReportRecord& report) const {
  traj::refuse_unmeasured(rules_.limits, place, report);
}

traj::ReportRecord Checker::trajectory(const geom::JsonFields& fields, const std::string& source,
                                       std::size_t line) const {
  const auto record = traj::read_trajectory_record(fields);
  traj::ReportRecord report{record.id, "trajectory", {}, record.provenance, {}, {}, {}};
  report.time = record.time;
  if (record.status != traj::TrajectoryStatus::solved) {
    together_.add(record, nullptr, source, line);
    report.result.reason = traj::reason_of(record.status);
    report.detail = record.message;
    return report;
  }
  const auto& scene = scenes_.scene_for(record.provenance, source, line);
  rules_.metres.check_input(scene.map().spec().frame, record.trajectory, source, line);
  report.limits = limits_for(record.limits, scene.vehicle());
  report.overridden = loosened(record, scene.vehicle(), report.limits);
  if (has_less_room(scene, record.provenance)) report.overridden.emplace_back("vehicle");
  report.provenance = geom::provenance_of(scene);
  together_.add(record, &scene, source, line);
  traj::CheckOptions options;
  options.limits = report.limits;
  options.clearance = rules_.clearance;
  options.start = geom::start_on(scene.map(), record.time, source, line);
  options.stands = together_.parks();
  report.by_time = options.start.has_value();
  report.result = traj::check(scene, record.trajectory, options);
  if (report.result.looked) {
    refuse_unmeasured(record.trajectory.segments.front().point.front(), report);
  }
  if (report.by_time) report.detail = standing_detail(report.result);
  if (rules_.exact) {
    report.exact = traj::check_exactly(
        exact_task(scene, report.limits, options.start, options.stands), record.trajectory);
  }
  traj::add_bounds(record, report);
  if (profile_.is_open() && report.result.duration > 0) {
    profile_.require_room(report.result.duration);
    profile_.add(record.id, traj::clearance_profile(scene, record.trajectory, profile_.step()));
  }
  return report;
}

traj::ReportRecord Checker::path(const geom::JsonFields& fields, const std::string& source,
                                 std::size_t line) const {
  const auto record = geom::read_path_record(fields);
  if (together_.collects()) together_.refuse_path(record.id, source, line);
  traj::ReportRecord report{record.id, "path", {}, record.provenance, {}, {}, {}};
  report.time = record.time;
  if (record.status != geom::PathStatus::found) {
    report.result.reason = traj::Reason::no_path;
    report.detail = record.message;
    return report;
  }
  const auto& scene = scenes_.scene_for(record.provenance, source, line);
  rules_.metres.check_input(scene.map().spec().frame, record.points, source, line);
  geom::start_on(scene.map(), {.epoch = record.time.epoch}, source, line);
  if (has_less_room(scene, record.provenance)) report.overridden.emplace_back("vehicle");
  report.provenance = geom::provenance_of(scene);
  report.result = traj::check_path(scene, record.points, {}, rules_.clearance);
  report.limits = rules_.limits;
  refuse_unmeasured(record.points.front(), report);
  if (rules_.exact) report.exact = traj::check_exactly(exact_task(scene, {}), record.points);
  traj::add_bounds(record, report);
  if (profile_.is_open()) {
    profile_.require_room(geom::length(record.points));
    profile_.add(record.id, traj::clearance_profile(scene, record.points, profile_.step()));
  }
  return report;
}

// What the proof allows for, beside the way.
void Checker::say_allowance(const traj::FileFlight& file, traj::ReportRecord& report) const {
  if (!file.format->is_flown) return;
  const traj::Flier& flier = *rules_.flier;
  const auto said = [](const geom::Vec3& box) { return std::array{box.x(), box.z()}; };
  const geom::Vec3 navigation = flier.allowance(false);
  report.navigation = said(navigation);
  if (!traj::has_drift(file.flown)) {
    report.tracking = said(flier.allowance(true) - navigation);
    return;
  }
  for (const traj::Drift& one : traj::mission_of(file.flown)->drift) {
    report.autopilot += (report.autopilot.empty() ? "" : ", ") + one.autopilot;
  }
  report.assumed = flier.assumed;
  report.drag = flier.autopilots.front().drag;
}

// What a drone makes of a file.
traj::ReportRecord Checker::flown(const traj::FileFlight& file) const {
  const auto& scene = scenes_.scene();
  const traj::FlownLegs* legs = traj::legs_of(file.flown);
  const traj::FlownMission* mission = traj::mission_of(file.flown);
  if (!file.format->is_flown) {
    rules_.metres.check_input(scene.map().spec().frame, legs->path, file.id, 0);
  }
  if (rules_.exact) require_exact(legs, mission);
  traj::ReportRecord report;
  report.id = file.id;
  report.checked = legs ? "path" : "trajectory";
  report.limits = limits_for({}, scene.vehicle());
  report.overridden = loosened({}, scene.vehicle(), report.limits);
  report.provenance = geom::provenance_of(scene);
  if (mission) {
    report.home = mission->home;
    report.idle_items = mission->idle_items;
    report.endless_jumps = mission->endless_jumps;
  }
  say_allowance(file, report);
  report.result = traj::judge(scene, file.flown, report.limits, rules_.clearance);
  report.detail = takeoff_detail(scene, report.result);
  if (report.result.looked) refuse_unmeasured(traj::begin_of(file.flown), report);
  const auto way = legs ? traj::whole_way(scene, *legs) : std::nullopt;
  if (way && rules_.exact) report.exact = traj::check_exactly(exact_task(scene, {}), *way);
  if (!profile_.is_open()) return report;
  if (way) profile_.require_room(geom::length(*way));
  if (way) profile_.add(file.id, traj::clearance_profile(scene, *way, profile_.step()));
  if (!legs && report.result.duration > 0) {
    profile_.require_room(report.result.duration);
    profile_.add(file.id,
                 traj::clearance_profile(scene, traj::trajectory_of(file.flown), profile_.step()));
  }
  return report;
}

traj::ReportRecord Checker::record(const std::string& text, const std::string& source,
                                   std::size_t line) const {
  const geom::JsonFields fields(text, source, line);
  return fields.text("type") == "path" ? path(fields, source, line)
                                       : trajectory(fields, source, line);
}

std::size_t Checker::each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                          const geom::Shard& shard, const Answer& answer) const {
  std::size_t total = 0;
  if (drone_file.format.empty()) {
    file.for_each_line([&](const std::string& line, std::size_t number) {
      if (shard.takes(total++)) answer(record(line, file.name(), number));
    });
    return total;
  }
  const geom::Frame& frame = scenes_.map().spec().frame;
  const std::string text = file.read_all();
  for (const auto& one : cli::read_drone_file(text, file.name(), drone_file, frame)) {
    if (!shard.takes(total++)) continue;
    for (const std::string& note : one.notes) common_.warn(one.id + ": " + note);
    const std::string corners = corner_note(traj::mission_of(one.flown));
    if (!corners.empty()) common_.warn(one.id + ": " + corners);
    answer(flown(one));
  }
  return total;
}

}  // namespace checking
