#include "flight_logs.h"

#include <fmt/format.h>

#include <utility>

#include "cli/batch.h"
#include "cli/beyond_bounds.h"
#include "cli/content/contents.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "traj/record/verdict.h"

namespace checking {

void FlightLogs::add_to(CLI::App& app) {
  app.add_option("--plan", plan_,
                 "trajectories that flight logs were to follow: the report says how far from them "
                 "they were");
  app.add_option(
      "--tube", tube_,
      "reports of skyway-fly --proved-tube or --runs: the map must be clear with the tube around "
      "each trajectory; of a flight log (with --plan), how much of it stayed within the tube");
  app.add_option("--require-clearance", rule_.clearance,
                 "accept flight logs that kept so many metres from obstacles at their samples and "
                 "straight between them; the report says what was not measured")
      ->check(CLI::Range(0.0, 1e4));
  app.add_flag("--sampled", rule_.sampled, "accept flight logs that touched nothing there")
      ->excludes("--require-clearance");
}

void FlightLogs::refuse_idle(const CLI::App& app, bool asked) const {
  cli::only_for(app, asked, {"--plan", "--require-clearance", "--sampled"}, "flight logs");
  if (!asked) return;
  constexpr const char* kApply = "records and drone files";
  cli::only_for(app, false,
                {"--exact", "--certificate", "--profile", "--no-clearance", "--spare", "--junit",
                 "--drop-refused"},
                kApply);
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    cli::only_for(app, false, {kind.option}, kApply);
  }
  if (!tube_.empty() && plan_.empty()) throw cli::UsageError("--tube needs --plan");
}

traj::FlightLogCheck FlightLogs::read_plans(const Run& run) const {
  const geom::BoxMap& map = run.scenes.map();
  traj::SampledRule rule = rule_;
  rule.any_map = run.override_record;
  traj::FlightLogCheck check(rule);
  if (plan_.empty()) return check;
  cli::Contents contents = cli::read_contents({plan_});
  cli::require_same_map(contents, &map, run.metres);
  for (auto& read : contents.trajectories) check.add_plan(std::move(read.record));
  if (!check.has_plans()) {
    throw geom::InputError(plan_, {.expected = "a solved trajectory", .found = "none"});
  }
  if (tube_.empty()) return check;
  cli::InputFile tubes(tube_);
  check.read_tubes(tubes.stream(), tubes.name(), map.spec().frame.axes);
  return check;
}

namespace {

// Warns of what a log does not say.
void warn_of(const traj::FlightLog& log, const traj::FlightLogCheck& check,
             const cli::Common& common) {
  const std::string id = geom::excerpt(log.id);
  if (log.map.empty()) {
    common.warn(fmt::format("{}: the log does not say its map: it is taken to be of this one", id));
  }
  if (log.cut) common.warn(fmt::format("{}: the log is cut: it is not the whole flight", id));
  if (check.has_plans() && !check.has_plan(log)) {
    common.warn(fmt::format("{}: --plan has no trajectory of that id", id));
  }
}

}  // namespace

cli::Exit FlightLogs::check(const Run& run) const {
  const ReportOutput& report = run.report;
  const geom::BoxMap& map = run.scenes.map();
  const traj::FlightLogCheck check = read_plans(run);
  cli::InputFile file(run.input);
  const auto logs = traj::read_flight_log(file.stream(), file.name());
  cli::RecordOutput out(report.file(), "output", run.sharding);
  traj::VerdictTable table;
  cli::Batch batch;
  cli::BeyondBounds beyond(map);
  std::size_t at = 0;
  std::size_t touched = 0;
  std::size_t refused = 0;
  for (const traj::FlightLog& log : logs) {
    if (!run.sharding.shard().takes(at++)) continue;
    run.metres.check_input(map.spec().frame, log, file.name() + ": " + geom::excerpt(log.id), 0);
    warn_of(log, check, run.common);
    const traj::SampledReport judged =
        check.judge(log, run.scenes.scene_for(check.made_for(log), file.name(), 0));
    const std::string_view reason = traj::reason_of(judged, map);
    touched += verdict(judged.result) != "sampled";
    refused += !reason.empty();
    if (judged.result.reason == traj::Reason::bounds) {
      beyond.add(judged.provenance, judged.result.place, judged.result.worst);
    }
    reason.empty() ? batch.add_good()
                   : batch.add_failed(reason, log.id + ": " + traj::in_words(judged, map));
    report.is_text() ? table.add(judged, map) : out.add(traj::to_json_line(judged, map));
  }
  for (const std::string& id : check.plans_without(logs)) {
    if (!rule_.clearance && !rule_.sampled) break;  // nothing is accepted
    ++refused;
    batch.add_failed("no_log", id + ": --plan has this flight, and no log has it");
  }
  const cli::Exit exit = refused > 0 ? cli::Exit::no : cli::Exit::yes;
  if (report.is_text()) out.add(table.text(report.colour()));
  out.commit(logs.size(), exit);
  if (report.tells()) batch.tell(run.common, "skyway-check", "flights are not proved");
  beyond.tell(run.common, "skyway-check");
  run.common.write_stats({{"records", logs.size()},
                          {"failed", touched},
                          {"refused", refused},
                          {"collision", run.scenes.stats()}});
  return exit;
}

}  // namespace checking
