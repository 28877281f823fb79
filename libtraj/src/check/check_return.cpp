#include "traj/check/check_return.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/usage_error.h"
#include "traj/curve/vertical_ends.h"
#include "traj/home/return_certificate.h"

namespace traj {
namespace {

using Stages = std::vector<FlightStage>;

void set_height(const ReturnRules& rules, ReturnModel& model) {
  if (rules.height) model.height = *rules.height;
}

ReturnTask task_of(const Flier& flier, const ReturnRules& rules) {
  ReturnTask task;
  task.action = rules.action;
  task.start = rules.start;
  task.room = flier.allowance(false);
  return task;
}

void look_for_height(const geom::CollisionScene& scene, const std::vector<Stages>& stages,
                     const ReturnTask& task, ReturnReport& report) {
  const auto best = best_return_height(scene, stages, task);
  if (!best) return;
  if (best->share == 1) {
    report.least_height = best->height;
  } else {
    report.best_height = best->height;
    report.best_share = best->share;
  }
}

ReturnReport prove(const geom::CollisionScene& scene, const std::vector<Stages>& stages,
                   const ReturnTask& task, const ReturnRules& rules) {
  ReturnReport report = prove_return(scene, stages, task);
  report.least_sought = rules.least_height && rules.action == ReturnAction::rtl;
  if (report.least_sought) look_for_height(scene, stages, task, report);
  if (rules.reasons && report.ok()) {
    report.reasons = return_reasons(scene, task, proved_stages(scene, stages, task));
  }
  return report;
}

// The ground below the place where a record begins.
Vec3 home_below(const geom::CollisionScene& scene, const Vec3& begin) {
  return {begin.x(), begin.y(), ground_below(scene, begin)};
}

// The ground below an end of a record, if it is level.
void add_pad(const geom::CollisionScene& scene, const Vec3& end, ReturnTask& task) {
  constexpr double kLevel = 1;  // m
  const LandingGround ground = landing_ground(scene, end, Vec3::Zero(), kLevel);
  if (ground.whole) task.pads.emplace_back(end.x(), end.y(), ground.height);
}

struct Ends {
  Vec3 begin;
  Vec3 end;
};

// Of a record, which any of the autopilots may fly.
ReturnReport prove_record(const geom::CollisionScene& scene, const Stages& stages, const Ends& ends,
                          const Flier& flier, const ReturnRules& rules) {
  ReturnTask task = task_of(flier, rules);
  task.room = flier.allowance(true);  // the model of an autopilot says how missions are followed
  task.home = rules.home ? *rules.home : home_below(scene, ends.begin);
  add_pad(scene, ends.begin, task);
  add_pad(scene, ends.end, task);
  for (const Autopilot& autopilot : flier.autopilots) {
    set_height(rules, task.models.emplace_back(return_model(autopilot)));
  }
  return prove(scene, std::vector<Stages>(task.models.size(), stages), task, rules);
}

// The stages of each autopilot that loads the mission, and its model.
void add_autopilots(const FlownMission& mission, const Flier& flier, const ReturnRules& rules,
                    ReturnTask& task, std::vector<Stages>& stages) {
  for (const Drift& drift : mission.drift) {
    const auto autopilot =
        std::find_if(flier.autopilots.begin(), flier.autopilots.end(),
                     [&](const Autopilot& one) { return one.name == drift.autopilot; });
    ReturnModel& model = task.models.emplace_back(return_model(*autopilot));
    model.around += mission.path_stray;
    set_height(rules, model);
    stages.push_back(stages_of(drift));
  }
}

void add_dji(const FlownMission& mission, const ReturnRules& rules, ReturnTask& task,
             std::vector<Stages>& stages) {
  const auto height = rules.height ? rules.height : mission.return_height;
  if (!height && rules.action == ReturnAction::rtl) {
    throw geom::UsageError(
        "the height of the return is a setting of the aircraft: give it with --return-height");
  }
  auto speed = mission.speed ? mission.speed : mission.speed_before_return;
  if (!speed) speed = rules.speed;
  if (!speed) {
    throw geom::UsageError(
        "the mission does not say its speed, so nobody knows how far it brakes: give it with "
        "--vmax");
  }
  ReturnModel& model = task.models.emplace_back(dji_return_model(height.value_or(0)));
  model.around += mission.path_stray;
  stages.push_back(stages_of(mission, *speed));
}

}  // namespace

ReturnReport check_return(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                          const Flier& flier, const ReturnRules& rules) {
  return prove_record(scene, stages_of(record.trajectory),
                      {record.trajectory.segments.front().point.front(),
                       record.trajectory.segments.back().point.back()},
                      flier, rules);
}

ReturnReport check_return(const geom::CollisionScene& scene, const geom::PathRecord& record,
                          const Flier& flier, const ReturnRules& rules) {
  if (!rules.speed) {
    throw geom::UsageError(
        "a path has no speed, so nobody knows how far its vehicle brakes: give it with --vmax");
  }
  FlownMission mission;
  mission.path = record.points;
  ReturnReport report = prove_record(scene, stages_of(mission, *rules.speed),
                                     {record.points.front(), record.points.back()}, flier, rules);
  for (ReturnGap& gap : report.gaps) gap.part.reset();  // a path has no items
  return report;
}

ReturnReport check_return(const geom::CollisionScene& scene, const FileFlight& file,
                          const Flier& flier, const ReturnRules& rules) {
  const FlownMission* mission = mission_of(file.flown);
  if (!mission) {
    throw geom::UsageError(
        fmt::format("--return takes missions and records: no autopilot returns from a file of {}",
                    file.format->format.word));
  }
  ReturnTask task = task_of(flier, rules);
  if (!rules.home && !mission->home) {
    throw geom::UsageError("the mission does not say where home is: give it with --home-place x,y,z");
  }
  task.home = rules.home ? *rules.home : *mission->home;
  task.rally = mission->rally_points;
  task.fences = mission->fences;
  std::vector<Stages> stages;
  if (mission->drift.empty()) {
    add_dji(*mission, rules, task, stages);
  } else {
    add_autopilots(*mission, flier, rules, task, stages);
  }
  return prove(scene, stages, task, rules);
}

}  // namespace traj
