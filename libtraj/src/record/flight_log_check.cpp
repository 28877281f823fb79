#include "traj/record/flight_log_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"

namespace traj {
namespace {

constexpr double kHair = 1e-6;  // seconds, or of a period, for rounding

// A tube of a shorter flight says nothing of the rest.
void require_whole(const TubeRecord& tube, const Trajectory& plan, const geom::JsonFields& fields) {
  const double periods = duration(plan) / tube.period;
  const auto has = static_cast<double>(tube.radius.size());
  if (has >= periods - kHair) return;
  fields.refuse(
      {.expected = fmt::format("a tube for the {:.6g} s of its plan", periods * tube.period),
       .found = fmt::format("one for {:.6g} s", has * tube.period),
       .advice = "fly this plan again (skyway-fly --runs)"});
}

}  // namespace

void FlightLogCheck::add_plan(TrajectoryRecord plan) {
  if (plan.status == TrajectoryStatus::solved) plans_.push_back({std::move(plan), {}});
}

void FlightLogCheck::read_tubes(std::istream& in, const std::string& source) {
  bool found = false;
  geom::for_each_line(in, source, [&](const std::string& text, std::size_t line) {
    const geom::JsonFields fields(text, source, line);
    fields.require_type("flight");
    const auto tube = read_tube(fields);
    const std::string id = fields.text("id");
    for (Plan& plan : plans_) {
      if (!tube || plan.record.id != id) continue;
      require_whole(*tube, plan.record.trajectory, fields);
      plan.tube = tube;
      found = true;
    }
  });
  if (found) return;
  throw geom::InputError(source, {.expected = "a flight of the plan with a tube",
                                  .found = "none",
                                  .advice = "skyway-fly --runs writes it"});
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
                       .cut = log.cut,
                       .provenance = geom::provenance_of(scene),
                       .rule = rule_};
  const Plan* const plan = plan_of(log.id);
  if (!plan) return report;
  const TubeRecord tube = plan->tube.value_or(TubeRecord{{}, 1});
  report.plan = flown_tube(plan->record.trajectory, tube.radius, tube.period, points, times);
  report.tube = plan->tube.has_value();
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
