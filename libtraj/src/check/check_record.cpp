#include "traj/check/check_record.h"

#include <fmt/format.h>

#include <array>

#include "geom/base/usage_error.h"
#include "geom/record/agreed_room.h"
#include "geom/record/start_on_map.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/mission/judge/judge.h"
#include "traj/mission/named_aircraft.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/record/checked_hash.h"

namespace traj {
namespace {

// The scene says only what vehicle it is for; the exact check looks at the map itself.
ExactTask exact_task(const geom::CollisionScene& scene, const Limits& limits,
                     const std::optional<double>& start = {}, bool stands = false) {
  return {scene.map(), scene.vehicle(), scene.margin(), limits, start, stands};
}

// Before anything was looked at.
template <class Record>
ReportRecord report_of(const Record& record, const char* checked) {
  ReportRecord report{.id = record.id, .checked = checked};
  report.provenance = record.provenance;
  report.time = record.time;
  return report;
}

template <class Record>
ReportRecord report_of_checked(const Record& record, const char* checked) {
  ReportRecord report = report_of(record, checked);
  report.checked_hash = checked_hash(record);
  return report;
}

// What the record asks for in vain, which only an override allows.
void say_less_room(const geom::CollisionScene& scene, ReportRecord& report) {
  if (geom::smaller_than_asked({scene.vehicle(), scene.margin()}, report.provenance)) {
    report.overridden.emplace_back("vehicle");
  }
  report.provenance = geom::provenance_of(scene);
}

// The limits that hold, and those of them that an override loosens.
void hold_limits(const geom::CollisionScene& scene, const RecordRules& rules, const Limits& record,
                 ReportRecord& report) {
  const Limits& vehicle = rules.of_vehicle ? *rules.of_vehicle : scene.vehicle().limits;
  report.limits = geom::limits_to_check({rules.asked, record, vehicle, rules.override_record},
                                        scene.vehicle().name);
  const Limits strict = geom::limits_that_hold({rules.asked, record, vehicle});
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    if (report.limits[kind.limit] != strict[kind.limit]) report.overridden.emplace_back(kind.name);
  }
}

// The box and the limits of the aircraft that a file names, as those that a record asks for.
Limits hold_aircraft(const geom::CollisionScene& scene, const RecordRules& rules,
                     const FileFlight& file, ReportRecord& report) {
  if (!rules.override_record) {
    require_room_for_aircraft(scene.vehicle(), file);
  } else if (!why_too_small(scene.vehicle(), file.vehicle).empty()) {
    report.overridden.emplace_back("vehicle");
  }
  const auto named = vehicle_named(file.vehicle);
  return named ? named->vehicle.limits : Limits{};
}

// Of a collision while it stands on its pads.
std::string standing_detail(const CheckResult& result) {
  if (result.reason != Reason::collision) return {};
  if (result.time < 0) return "where it stands before it begins";
  return result.time > result.duration ? "where it stands after its end" : "";
}

// What is in the way of a take-off.
std::string takeoff_detail(const geom::CollisionScene& scene, const CheckResult& result) {
  if (result.reason != Reason::takeoff) return {};
  return fmt::format(
      "the flight begins {:.3g} m above the ground that it takes off from, and the vehicle reaches "
      "{:.3g} m below its reference point: it would begin inside the ground",
      result.worst, scene.half().z());
}

// Whether the exact check takes a drone file.
bool is_straight(const Flown& flown) {
  const FlownMission* mission = mission_of(flown);
  if (mission && mission->terrain) return false;
  return legs_of(flown) && (!mission || (mission->sweeps.empty() && mission->fences.empty()));
}

void require_exact(const Flown& flown) {
  if (is_straight(flown)) return;
  if (!legs_of(flown)) {
    throw geom::UsageError("--exact takes paths and records, not files of trajectories");
  }
  throw geom::UsageError(
      "--exact takes straight legs: this mission has corners, curves, fences or heights above "
      "terrain as well; check it without --exact");
}

// What the proof allows for, beside the way.
void say_allowance(const FileFlight& file, const Flier& flier, ReportRecord& report) {
  if (!file.format->is_flown) return;
  const auto said = [](const Vec3& box) { return std::array{box.x(), box.z()}; };
  const Vec3 navigation = flier.allowance(false);
  report.navigation = said(navigation);
  if (!has_drift(file.flown)) {
    report.tracking = said(flier.allowance(true) - navigation);
    return;
  }
  for (const Drift& one : mission_of(file.flown)->drift) {
    report.autopilot += (report.autopilot.empty() ? "" : ", ") + one.autopilot;
  }
  report.assumed = flier.assumed;
  report.drag = flier.autopilots.front().drag;
}

}  // namespace

ReportRecord unsolved_report(const TrajectoryRecord& record) {
  ReportRecord report = report_of(record, "trajectory");
  report.result.reason = reason_of(record.status);
  report.detail = record.message;
  return report;
}

ReportRecord unsolved_report(const geom::PathRecord& record) {
  ReportRecord report = report_of(record, "path");
  report.result.reason = Reason::no_path;
  report.detail = record.message;
  return report;
}

ReportRecord check_record(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                          const RecordRules& rules, std::string_view source, std::size_t line) {
  if (record.status != TrajectoryStatus::solved) return unsolved_report(record);
  ReportRecord report = report_of_checked(record, "trajectory");
  hold_limits(scene, rules, record.limits, report);
  say_less_room(scene, report);
  CheckOptions options;
  options.limits = report.limits;
  options.clearance = rules.clearance;
  options.start = geom::start_on(scene.map(), record.time, source, line);
  options.stands = rules.stands;
  report.by_time = options.start.has_value();
  report.result = check(scene, record.trajectory, options);
  if (report.result.looked) {
    refuse_unmeasured(rules.asked, record.trajectory.segments.front().point.front(), report);
  }
  if (report.by_time) report.detail = standing_detail(report.result);
  if (rules.exact) {
    const auto task = exact_task(scene, report.limits, options.start, options.stands);
    report.exact = check_exactly(task, record.trajectory);
  }
  add_bounds(record, report);
  return report;
}

ReportRecord check_record(const geom::CollisionScene& scene, const geom::PathRecord& record,
                          const RecordRules& rules, std::string_view source, std::size_t line) {
  if (record.status != geom::PathStatus::found) return unsolved_report(record);
  ReportRecord report = report_of_checked(record, "path");
  geom::start_on(scene.map(), {.epoch = record.time.epoch}, source, line);
  say_less_room(scene, report);
  report.result = check_path(scene, record.points, {}, rules.clearance);
  report.limits = rules.asked;
  refuse_unmeasured(rules.asked, record.points.front(), report);
  if (rules.exact) report.exact = check_exactly(exact_task(scene, {}), record.points);
  add_bounds(record, report);
  return report;
}

ReportRecord check_record(const geom::CollisionScene& scene, const FileFlight& file,
                          const Flier& flier, const RecordRules& rules) {
  const bool exact = rules.exact && (!rules.exact_if_straight || is_straight(file.flown));
  if (exact) require_exact(file.flown);
  const FlownLegs* legs = legs_of(file.flown);
  ReportRecord report{.id = file.id, .checked = legs ? "path" : "trajectory"};
  const Limits aircraft = hold_aircraft(scene, rules, file, report);
  hold_limits(scene, rules, aircraft, report);
  report.provenance = geom::provenance_of(scene);
  if (const FlownMission* mission = mission_of(file.flown)) {
    report.home = mission->home;
    report.idle_items = mission->idle_items;
    report.endless_jumps = mission->endless_jumps;
    report.terrain = mission->terrain;
  }
  say_allowance(file, flier, report);
  report.result = judge(scene, file.flown, report.limits, rules.clearance);
  report.detail = takeoff_detail(scene, report.result);
  if (report.result.looked) refuse_unmeasured(rules.asked, begin_of(file.flown), report);
  if (!exact) return report;
  if (const auto way = whole_way(scene, *legs)) {
    report.exact = check_exactly(exact_task(scene, {}), *way);
  }
  return report;
}

std::string corner_note(const Flown& flown) {
  const FlownMission* mission = mission_of(flown);
  if (!mission || mission->corners == 0) return {};
  const std::string where =
      fmt::format("{} waypoint{}", mission->corners, mission->corners == 1 ? "" : "s");
  if (mission->acceptance == 0) {
    return fmt::format(
        "the vehicle does not stop at {}: as --acceptance 0 says, it is taken to go "
        "to each before it turns",
        where);
  }
  return fmt::format(
      "the vehicle does not stop at {}: corners were looked at within {:.3g} m "
      "(--acceptance says otherwise)",
      where, mission->acceptance);
}

}  // namespace traj
