#include "contingencies.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/shard/record_output.h"
#include "geom/base/in_order.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"
#include "traj/home/flight_contingencies.h"
#include "traj/home/home_flight.h"
#include "traj/record/verdict.h"
#include "traj/record/verdict_table.h"

namespace checking {
namespace {

constexpr std::size_t kFlightsHeld = 64;  // at a time

struct CheckedFlight {
  geom::RecordLine line;
  traj::CheckedContingencies checked = {};
};

traj::FlightContingencies read_contingencies(const std::string& path,
                                             const Contingencies::Run& run) {
  traj::ContingencyRules rules{.models = traj::return_models(run.autopilot.flier)};
  if (run.scenes.profile()) rules.energy = run.scenes.profile()->energy;
  cli::InputFile file(path);
  return {file.stream(), file.name(), std::move(rules)};
}

}  // namespace

void Contingencies::add_to(CLI::App& app) {
  app.add_option("--contingencies", file_,
                 "prove the ways home of skyway-plan --home: from every instant of each flight");
}

void Contingencies::refuse_idle(const CLI::App& app) const {
  if (!asked()) return;
  cli::only_for(app, false,
                {"--profile", "--override", "--no-clearance", "--spare", "--junit",
                 "--drop-refused", "--together", "--moving", "--return"},
                "the flights themselves: leave --contingencies out");
  for (const geom::LimitKind& kind : geom::kLimitKinds) {
    if (kind.limit != geom::Limit::speed) {
      cli::only_for(app, false, {kind.option}, "the flights themselves: leave --contingencies out");
    }
  }
}

void Contingencies::settle(cli::DroneFileOptions& drone_file, cli::VehicleOptions& vehicle) const {
  if (!drone_file.format.empty()) {
    throw cli::UsageError("--contingencies are of trajectories and paths, and FILE is neither");
  }
  drone_file.autopilot.settle(vehicle.profile());
  if (!vehicle.margin) return;
  const auto models = traj::return_models(drone_file.autopilot.flier);
  vehicle.margin = std::max(*vehicle.margin, traj::least_margin(models));
}

cli::Exit Contingencies::check(const Run& run) const {
  const traj::FlightContingencies ways = read_contingencies(file_, run);
  const traj::ContingencyProof proof{run.exact, !run.certificate.empty()};
  const geom::BoxMap& map = run.scenes.map();
  cli::InputFile& file = run.flights;
  cli::RecordOutput out(run.report.file(), "output", run.sharding);
  std::optional<cli::RecordOutput> certificates;
  if (!run.certificate.empty()) certificates.emplace(run.certificate, "certificate", run.sharding);
  geom::RecordLines lines(file.stream(), file.name());
  traj::VerdictTable table;
  cli::Batch batch;
  std::size_t total = 0;
  std::size_t failed = 0;
  std::atomic<bool> paths = false;
  std::set<std::string> flights;
  const auto next = [&]() -> std::optional<CheckedFlight> {
    while (auto line = lines.next()) {
      if (run.sharding.shard().takes(total++)) return CheckedFlight{*std::move(line)};
    }
    return std::nullopt;
  };
  const auto work = [&](CheckedFlight& item) {
    const std::size_t line = item.line.number;
    const traj::HomeFlight flight =
        traj::read_home_flight(geom::JsonFields(item.line.text, file.name(), line), run.vmax);
    const auto scene = run.scenes.shared_scene_for(ways.room_of(flight), file.name(), line);
    run.metres.check_input(scene->map().spec().frame, flight.places(), file.name(), line);
    item.checked = ways.check(*scene, flight, proof);
    if (flight.kind == "path") paths = true;
  };
  const auto take = [&](CheckedFlight& item) {
    const traj::ReportRecord& report = item.checked.report;
    const bool ok = traj::accepted(report);
    failed += !ok;
    flights.insert(report.id);
    ok ? batch.add_good()
       : batch.add_failed(traj::verdict_word(report),
                          report.id + ": " + traj::in_words(report, map));
    if (certificates) certificates->add(item.checked.certificate);
    run.report.is_text() ? table.add(report, map) : out.add(traj::to_json_line(report, map));
  };
  geom::in_order<CheckedFlight>(run.common.execution("flights"), kFlightsHeld, next, work, take);
  if (!run.sharding.asked()) ways.require_used(flights);
  if (!run.sharding.asked()) traj::require_vmax_used(run.vmax, paths);
  const cli::Exit exit = failed > 0 ? cli::Exit::no : cli::Exit::yes;
  if (run.report.is_text()) out.add(table.text(run.report.colour()));
  out.commit(total, exit);
  if (certificates) certificates->commit(total, exit);
  if (run.report.tells())
    batch.tell(run.common, "skyway-check", "flights have no way home at some times");
  run.common.write_stats(
      {{"records", total}, {"failed", failed}, {"collision", run.scenes.stats()}});
  return exit;
}

}  // namespace checking
