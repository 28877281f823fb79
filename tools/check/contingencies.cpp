#include "contingencies.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/shard/record_output.h"
#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"
#include "traj/home/check_contingencies.h"
#include "traj/home/contingency_proof.h"
#include "traj/home/home_flight.h"
#include "traj/record/verdict.h"
#include "traj/record/verdict_table.h"

namespace checking {
namespace {

constexpr std::size_t kFlightsHeld = 64;  // at a time

using ById = std::map<std::string, std::vector<traj::ContingencyRecord>>;

ById read_contingencies(const std::string& path) {
  cli::InputFile file(path);
  ById out;
  geom::for_each_line(file.stream(), file.name(), [&](const std::string& text, std::size_t line) {
    traj::ContingencyRecord record = traj::parse_contingency_record(text, file.name(), line);
    out[record.id].push_back(std::move(record));
  });
  return out;
}

struct CheckedFlight {
  geom::RecordLine line;
  traj::ReportRecord report = {};
  std::string certificate = {};  // a line, where it is asked for
};

// Flights of any vehicle held against their contingencies.
class ContingencyChecker {
 public:
  ContingencyChecker(const Contingencies::Run& run, std::string source, ById records)
      : run_(run), source_(std::move(source)), records_(std::move(records)) {
    rules_.models = traj::return_models(run.autopilot.flier);
    if (run.scenes.profile()) rules_.energy = run.scenes.profile()->energy;
  }

  // Threads may call at once.
  void check(CheckedFlight& item, const std::string& source) const {
    const std::size_t line = item.line.number;
    const traj::HomeFlight flight =
        traj::read_home_flight(geom::JsonFields(item.line.text, source, line), run_.vmax);
    const auto found = records_.find(flight.id);
    const std::vector<traj::ContingencyRecord> none;
    const auto& records = found == records_.end() ? none : found->second;
    const auto scene = run_.scenes.shared_scene_for(room_of(flight, records), source, line);
    run_.metres.check_input(scene->map().spec().frame, flight.places(), source, line);
    item.report = traj::check_contingencies(*scene, flight.id, flight.stages, records, rules_);
    if (!item.report.result.ok || !(run_.exact || !run_.certificate.empty())) return;
    const auto ways = traj::proved_ways(*scene, flight.stages, records, rules_);
    const traj::ExactTask task{scene->map(), scene->vehicle(), scene->margin()};
    item.report.exact = traj::check_exactly(task, flight.stages, ways);
    if (run_.certificate.empty() || !item.report.exact->ok) return;
    item.certificate = traj::contingency_certificate_line(*scene, flight.id, flight.kind,
                                                          flight.stages, ways, rules_);
  }

  // Throws InputError for contingencies of a flight that is not among these.
  void require_used(const std::set<std::string>& flights) const {
    for (const auto& [id, records] : records_) {
      if (flights.contains(id)) continue;
      throw geom::InputError(source_, {.expected = "contingencies of the flights that are checked",
                                       .found = fmt::format("some of flight {}", id)});
    }
  }

 private:
  // The largest margin of the flight, its contingencies and the autopilots. All must be of one map.
  geom::Provenance room_of(const traj::HomeFlight& flight,
                           const std::vector<traj::ContingencyRecord>& records) const {
    geom::Provenance out = flight.provenance;
    double margin = std::max(out.margin.value_or(0), traj::least_margin(rules_.models));
    for (const traj::ContingencyRecord& record : records) {
      geom::require_map_agrees(record.provenance, flight.provenance, source_, 0);
      margin = std::max(margin, record.provenance.margin.value_or(0));
    }
    out.margin = margin;
    return out;
  }

  const Contingencies::Run& run_;
  std::string source_;  // of the records
  ById records_;
  traj::ContingencyRules rules_;
};

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
  const ContingencyChecker checker(run, file_, read_contingencies(file_));
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
  std::set<std::string> flights;
  const auto next = [&]() -> std::optional<CheckedFlight> {
    while (auto line = lines.next()) {
      if (run.sharding.shard().takes(total++)) return CheckedFlight{*std::move(line)};
    }
    return std::nullopt;
  };
  const auto work = [&](CheckedFlight& item) { checker.check(item, file.name()); };
  const auto take = [&](CheckedFlight& item) {
    const traj::ReportRecord& report = item.report;
    const bool ok = traj::accepted(report);
    failed += !ok;
    flights.insert(report.id);
    ok ? batch.add_good()
       : batch.add_failed(traj::verdict_word(report),
                          report.id + ": " + traj::in_words(report, map));
    if (certificates) certificates->add(item.certificate);
    run.report.is_text() ? table.add(report, map) : out.add(traj::to_json_line(report, map));
  };
  geom::in_order<CheckedFlight>(run.common.execution("flights"), kFlightsHeld, next, work, take);
  if (!run.sharding.asked()) checker.require_used(flights);
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
