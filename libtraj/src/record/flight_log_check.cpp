#include "traj/record/flight_log_check.h"

#include <algorithm>
#include <utility>

#include "geom/base/error.h"
#include "traj/record/checked_hash.h"
#include "traj/record/tube_reports.h"

namespace traj {
namespace {

constexpr double kHair = 1e-6;  // seconds, for rounding

}  // namespace

void FlightLogCheck::add_plan(TrajectoryRecord plan) {
  if (plan.status == TrajectoryStatus::solved) plans_.push_back({std::move(plan), {}});
}

void FlightLogCheck::read_tubes(std::istream& in, const std::string& source, geom::Axes axes) {
  const TubeReports tubes = TubeReports::read(in, source);
  for (Plan& plan : plans_) {
    const geom::Provenance& made_for = plan.record.provenance;
    plan.tube =
        tubes.require_tube(plan.record.id, plan.record.trajectory,
                           {.frame = made_for.frame.value_or(axes), .vehicle = made_for.vehicle});
  }
}

const FlightLogCheck::Plan* FlightLogCheck::plan_of(const std::string& id) const {
  const auto same = std::find_if(plans_.begin(), plans_.end(),
                                 [&](const Plan& plan) { return plan.record.id == id; });
  if (same != plans_.end()) return &*same;
  return plans_.size() == 1 ? &plans_.front() : nullptr;
}

geom::Provenance FlightLogCheck::made_for(const FlightLog& log) const {
  geom::Provenance out;
  if (!log.map.empty()) out.map = log.map;
  if (const Plan* const plan = plan_of(log.id)) out.vehicle = plan->record.provenance.vehicle;
  return out;
}

SampledReport FlightLogCheck::judge(const FlightLog& log, const geom::CollisionScene& scene) const {
  const geom::Axes axes = scene.map().spec().frame.axes;
  std::vector<Vec3> points;
  std::vector<double> times;
  for (const FlightSample& sample : log.samples) {
    points.push_back(geom::to_enu(axes, sample.position));
    times.push_back(sample.time);
  }
  SampledReport report{.id = log.id,
                       .result = check_sampled(scene, points, times),
                       .samples = points.size(),
                       .cut = log.cut || points.size() < 2,  // one place is no flight
                       .provenance = geom::provenance_of(scene),
                       .rule = rule_,
                       .map_said = !log.map.empty(),
                       .checked_hash = checked_hash(log)};
  const Plan* const plan = plan_of(log.id);
  if (!plan) return report;
  const TubeRecord tube = plan->tube.value_or(TubeRecord{.period = 1});
  report.plan = flown_tube(plan->record.trajectory, tube.radius, tube.period, points, times);
  if (plan->tube) report.tube = plan->tube->claim.kind;
  report.short_of_plan = times.back() - times.front() < duration(plan->record.trajectory) - kHair;
  return report;
}

std::vector<std::string> FlightLogCheck::plans_without(std::span<const FlightLog> logs) const {
  std::vector<std::string> out;
  for (const Plan& plan : plans_) {
    const auto is_of_plan = [&](const FlightLog& log) { return plan_of(log.id) == &plan; };
    if (std::none_of(logs.begin(), logs.end(), is_of_plan)) out.push_back(plan.record.id);
  }
  return out;
}

}  // namespace traj
