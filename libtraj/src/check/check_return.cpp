#include "traj/check/check_return.h"

#include <fmt/format.h>

#include "geom/base/usage_error.h"
#include "traj/home/flight_return.h"
#include "traj/home/return_certificate.h"
#include "traj/mission/judge/judge.h"

namespace traj {
namespace {

using Stages = std::vector<FlightStage>;

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

ReturnReport prove(const geom::CollisionScene& scene, FlightReturn flight,
                   const ReturnRules& rules) {
  flight.task.action = rules.action;
  flight.task.start = rules.start;
  if (rules.home) flight.task.home = *rules.home;
  ReturnReport report = prove_return(scene, flight.stages, flight.task);
  report.timeline = std::move(flight.timeline);
  report.least_sought = rules.least_height && rules.action == ReturnAction::rtl;
  if (report.least_sought) look_for_height(scene, flight.stages, flight.task, report);
  if (rules.reasons && report.ok()) {
    report.reasons =
        return_reasons(scene, flight.task, proved_stages(scene, flight.stages, flight.task));
  }
  return report;
}

}  // namespace

ReturnReport check_return(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                          const Flier& flier, const ReturnRules& rules) {
  return prove(scene, flight_return(scene, record.trajectory, flier, rules.height), rules);
}

ReturnReport check_return(const geom::CollisionScene& scene, const geom::PathRecord& record,
                          const Flier& flier, const ReturnRules& rules) {
  if (!rules.speed) {
    throw geom::UsageError(
        "a path has no speed, so nobody knows how far its vehicle brakes: give it with --vmax");
  }
  FlownMission mission;
  mission.path = record.points;
  FlightReturn flight =
      flight_return(scene, stages_of(mission, *rules.speed), record.points.front(),
                    record.points.back(), flier, rules.height);
  flight.timeline = timeline_of(mission, *rules.speed);
  ReturnReport report = prove(scene, std::move(flight), rules);
  for (ReturnGap& gap : report.gaps) gap.part.reset();  // a path has no items
  return report;
}

ReturnReport check_return(const geom::CollisionScene& scene, const FileFlight& file,
                          const Flier& flier, const ReturnRules& rules) {
  const FlownMission* flown = mission_of(file.flown);
  if (!flown) {
    throw geom::UsageError(
        fmt::format("--return takes missions and records: no autopilot returns from a file of {}",
                    file.format->format.word));
  }
  if (flown->terrain) {
    throw geom::UsageError(
        "--return takes missions whose heights are known: over terrain nobody knows how high a "
        "return begins");
  }
  FlownMission mission = *flown;
  if (rules.home) mission.home = rules.home;
  if (!mission.home) {
    throw geom::UsageError(
        "the mission does not say where home is: give it with --home-place x,y,z");
  }
  ReturnReport report =
      prove(scene,
            mission.drift.empty()
                ? dji_flight_return(scene, mission, flier,
                                    {rules.height, rules.speed, rules.action == ReturnAction::rtl})
                : flight_return(mission, flier, rules.height),
            rules);
  if (report.reasons.empty()) return report;
  if (auto way = whole_way(scene, mission)) report.way = *std::move(way);
  return report;
}

}  // namespace traj
