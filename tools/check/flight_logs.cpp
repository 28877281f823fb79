#include "flight_logs.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/json_fields.h"

namespace checking {

void FlightLogs::add_to(CLI::App& app) {
  app.add_option("--plan", plan_,
                 "trajectories that flight logs were to follow: the report says how far from them "
                 "they were");
  app.add_option(
      "--tube", tube_,
      "report of skyway-fly --runs of the plan: how much of the flight stayed within its "
      "tube");
}

void FlightLogs::refuse_idle(const CLI::App& app, bool asked) const {
  cli::only_for(app, asked, {"--plan", "--tube"}, "flight logs (--file-format flight-log)");
  if (!asked) return;
  constexpr const char* kApply = "records and drone files";
  cli::only_for(app, false,
                {"--exact", "--certificate", "--profile", "--override", "--no-clearance", "--spare",
                 "--junit"},
                kApply);
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    cli::only_for(app, false, {kind.option}, kApply);
  }
  if (!tube_.empty() && plan_.empty()) throw cli::UsageError("--tube needs --plan");
}

void FlightLogs::read_plan(const geom::BoxMap& map, const cli::MetresOption& metres) {
  cli::Contents contents = cli::read_contents({plan_});
  cli::require_same_map(contents, &map, metres);
  for (auto& read : contents.trajectories) {
    if (read.record.status != traj::TrajectoryStatus::solved) continue;
    plans_.push_back({std::move(read.record), {}});
  }
  if (plans_.empty())
    throw geom::InputError(plan_, {.expected = "a solved trajectory", .found = "none"});
}

// A tube of a shorter flight says nothing of the rest.
void FlightLogs::require_whole(const traj::TubeRecord& tube, const Plan& plan,
                               const geom::JsonFields& fields) {
  constexpr double kHair = 1e-6;  // of a period, for rounding
  const double periods = traj::duration(plan.record.trajectory) / tube.period;
  if (static_cast<double>(tube.radius.size()) >= periods - kHair) return;
  fields.refuse(
      {.expected = fmt::format("a tube for the {:.6g} s of its plan", periods * tube.period),
       .found =
           fmt::format("one for {:.6g} s", static_cast<double>(tube.radius.size()) * tube.period),
       .advice = "fly this plan again (skyway-fly --runs)"});
}

void FlightLogs::read_tubes() {
  cli::InputFile file(tube_);
  bool found = false;
  file.for_each_line([&](const std::string& text, std::size_t line) {
    const geom::JsonFields fields(text, file.name(), line);
    fields.require_type("flight");
    const auto tube = traj::read_tube(fields);
    const std::string id = fields.text("id");
    for (Plan& plan : plans_) {
      if (!tube || plan.record.id != id) continue;
      require_whole(*tube, plan, fields);
      plan.tube = tube;
      found = true;
    }
  });
  if (!found) {
    throw geom::InputError(tube_, {.expected = "a flight of the plan with a tube",
                                   .found = "none",
                                   .advice = "skyway-fly --runs writes it"});
  }
}

// The trajectory of that id, else the only one.
const FlightLogs::Plan* FlightLogs::plan_of(const std::string& id) const {
  const auto same = std::find_if(plans_.begin(), plans_.end(),
                                 [&](const Plan& plan) { return plan.record.id == id; });
  if (same != plans_.end()) return &*same;
  return plans_.size() == 1 ? &plans_.front() : nullptr;
}

traj::SampledReport FlightLogs::report_of(const traj::FlightLog& log, cli::Scenes& scenes,
                                          const std::string& source) const {
  geom::Provenance made_for;
  if (!log.map.empty()) made_for.map = log.map;
  const Plan* const plan = plan_of(log.id);
  if (plan) made_for.vehicle = plan->record.provenance.vehicle;
  const geom::CollisionScene& scene = scenes.scene_for(made_for, source, 0);
  const geom::Axes axes = scenes.map().spec().frame.axes;
  std::vector<geom::Vec3> points;
  std::vector<double> times;
  for (const traj::FlightSample& sample : log.samples) {
    points.push_back(geom::to_enu(axes, sample.position));
    times.push_back(sample.time);
  }
  traj::SampledReport report{log.id,
                             traj::check_sampled(scene, points, times),
                             points.size(),
                             log.cut,
                             {},
                             false,
                             geom::provenance_of(scene)};
  if (!plan) return report;
  const traj::TubeRecord tube = plan->tube.value_or(traj::TubeRecord{{}, 1});
  report.plan = traj::flown_tube(plan->record.trajectory, tube.radius, tube.period, points, times);
  report.tube = plan->tube.has_value();
  return report;
}

cli::Exit FlightLogs::check(const cli::Common& common, const std::string& input,
                            cli::Scenes& scenes, const cli::MetresOption& metres,
                            const cli::Sharding& sharding, const std::string& output) {
  if (!plan_.empty()) read_plan(scenes.map(), metres);
  if (!tube_.empty()) read_tubes();
  cli::InputFile file(input);
  const auto logs = traj::read_flight_log(file.stream(), file.name());
  cli::RecordOutput out(output, "output", sharding);
  cli::Batch batch;
  std::size_t at = 0;
  std::size_t touched = 0;
  for (const traj::FlightLog& log : logs) {
    if (!sharding.shard().takes(at++)) continue;
    const std::string id = geom::excerpt(log.id);
    metres.check_input(scenes.map().spec().frame, log, file.name() + ": " + id, 0);
    if (log.map.empty()) {
      common.warn(
          fmt::format("{}: the log does not say its map: it is taken to be of this one", id));
    }
    if (log.cut) common.warn(fmt::format("{}: the log broke off: what followed is not known", id));
    if (!plans_.empty() && !plan_of(log.id)) {
      common.warn(fmt::format("{}: --plan has no trajectory of that id", id));
    }
    const traj::SampledReport report = report_of(log, scenes, file.name());
    batch.add_failed(verdict(report.result));
    touched += verdict(report.result) != "sampled";
    out.add(traj::to_json_line(report, scenes.map()));
  }
  out.commit(logs.size(), cli::Exit::no);
  batch.tell(common, "skyway-check", "flights are not proved");
  common.write_stats(
      {{"records", logs.size()}, {"failed", touched}, {"collision", scenes.stats()}});
  return cli::Exit::no;
}

}  // namespace checking
