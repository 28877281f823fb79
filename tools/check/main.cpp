// skyway-check: prove that trajectories and paths are clear of a map and inside their limits.

#include <fmt/format.h>

#include <algorithm>

#include "checker.h"
#include "cli/option/limit_options.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "contingencies.h"
#include "flight_logs.h"
#include "folder.h"
#include "geom/record/agreed_room.h"
#include "geom/record/named_map.h"
#include "report_output.h"
#include "reports.h"
#include "returns.h"
#include "together.h"
#include "traj/record/verdict.h"

namespace {

struct Options {
  std::string map;
  std::string input = "-";
  checking::ReportOutput report;
  std::string certificate;
  checking::ProfileFile profile;
  std::string junit;
  cli::VehicleOptions vehicle;
  cli::LimitOptions limits;
  bool override_record = false;
  bool exact = false;
  bool no_clearance = false;
  bool drop_refused = false;
  cli::DroneFileOptions drone_file;
  checking::Returns returns;
  checking::Contingencies contingencies;
  checking::Together together;
  checking::FlightLogs flights;
  cli::MetresOption metres;

  bool flight_log() const { return drone_file.is_flight_log(); }
  void add_to(CLI::App& app);
  void refuse_idle(const CLI::App& app) const;
  bool decides_exactly() const { return exact || !certificate.empty(); }
  std::optional<traj::ReturnRules> return_rules() const {
    if (!returns.asked()) return std::nullopt;
    traj::ReturnRules rules =
        returns.rules(drone_file.reading.rules.return_height, limits.limits()[traj::Limit::speed]);
    rules.reasons = !certificate.empty();
    return rules;
  }
  checking::Rules rules() const {
    return {{.asked = limits.limits(),
             .override_record = override_record,
             .exact = decides_exactly(),
             .exact_if_straight = returns.asked() && !exact,
             .stands = together.parks(),
             .clearance = no_clearance ? traj::Clearance::left_out : traj::Clearance::measured},
            &drone_file.autopilot.flier,
            return_rules(),
            metres};
  }
  checking::ReportFiles files() {
    return {report, certificate, profile, junit, together.parks(), drop_refused};
  }
};

void Options::add_to(CLI::App& app) {
  app.add_option("map", map,
                 "box map, - for stdin; or a folder of skyway-submit, which is checked whole")
      ->required();
  app.add_option("file", input,
                 "trajectories, paths, a drone file or a flight log (default: stdin)");
  report.add_to(app);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  vehicle.add_spare_to(app);
  limits.add_to(app);
  app.add_flag(
      "--override", override_record,
      "let options and --vehicle be looser than what the records carry, and a flight log be "
      "of any map");
  app.add_flag("--exact", exact, "check once more in exact numbers; both must accept");
  app.add_flag("--no-clearance", no_clearance,
               "leave the clearance out of the reports: it costs more than the verdict");
  app.add_flag("--drop-refused", drop_refused,
               "leave records out that are refused, and answer for the others");
  profile.add_to(app);
  cli::add_output(app, "--junit", junit, "write the verdicts as a JUnit test suite, XML");
  cli::add_output(
      app, "--certificate", certificate,
      "write the reasons why each accepted record is clear, JSON Lines; implies --exact");
  drone_file.add_to(app);
  returns.add_to(app);
  contingencies.add_to(app);
  flights.add_to(app);
  together.add_to(app);
  metres.add_to(app);
}

void Options::refuse_idle(const CLI::App& app) const {
  flights.refuse_idle(app, flight_log());
  returns.refuse_idle(app);
  contingencies.refuse_idle(app);
  cli::only_for(app, !flight_log(), {"--return"}, "records and drone files");
  together.refuse_idle(app, !drone_file.format.empty());
  cli::only_for(app, (flight_log() || drone_file.format.empty()) && !contingencies.asked(),
                {"--tube"}, "trajectories and flight logs");
  cli::only_for(app, !profile.file().empty(), {"--profile-step"}, "--profile");
  drone_file.terrain.refuse_idle(drone_file.reading.rules);
  if (drone_file.format.empty()) {
    drone_file.require_used(cli::kRecordsWord, "FILE is read as records");
  }
  if (flight_log()) drone_file.require_used(cli::kFlightLogWord, "FILE is read as a flight log");
}

nlohmann::ordered_json check_together(const cli::Common& common, checking::Together& together,
                                      bool exact, checking::Reports& reports) {
  const traj::TogetherResult result = together.check(exact, common.execution("pairs"));
  reports.add(together, result);
  const nlohmann::ordered_json verdict = {{"checked", result.pairs},
                                          {"refused", result.refused.size()},
                                          {"left_out", together.left_out()}};
  if (result.ok() || !reports.tells()) return verdict;
  const auto nearest = std::min_element(
      result.refused.begin(), result.refused.end(),
      [](const auto& a, const auto& b) { return a.result.share < b.result.share; });
  cli::tell(common, "skyway-check",
            fmt::format("{} of {} pairs come too near; the nearest: {}", result.refused.size(),
                        result.pairs, traj::in_words(*nearest, together.task())));
  return verdict;
}

traj::MovingObstacles read_moving(const cli::Moving& option, const geom::BoxMap& map,
                                  const cli::MetresOption& metres) {
  traj::MovingObstacles moving = option.read();
  geom::NamedMap named(map);
  moving.require_of(named, cli::look_at_boxes(metres, map.spec().frame));
  return moving;
}

nlohmann::ordered_json check_moving(const cli::Common& common, const traj::MovingObstacles& moving,
                                    const checking::Together& together, bool exact,
                                    checking::Reports& reports) {
  const auto found = moving.check(together.flights(), together.task(), together.left_out(), exact,
                                  common.execution("flights"));
  reports.add(found);
  const nlohmann::ordered_json verdict = {
      {"checked", found.summary.flights * found.summary.obstacles},
      {"refused", found.summary.refused},
      {"left_out", found.summary.left_out}};
  if (found.conflicts.empty() || !reports.tells()) return verdict;
  cli::tell(common, "skyway-check",
            fmt::format("{} meetings with obstacles that move; the first: {}",
                        found.conflicts.size(), traj::in_words(found.conflicts.front())));
  return verdict;
}

// Says the verdict on single records and the verdict on pairs in one line: "records: 4 of 1000
// failed and are left out; pairs: 0 of 495510 refused".
void tell_verdicts(const cli::Common& common, const nlohmann::ordered_json& verdicts) {
  const bool together = verdicts.contains("pairs") || verdicts.contains("moving");
  if (verdicts["failed"] == 0 || verdicts["records"] == 1 ||
      (!together && verdicts["dropped"] == 0))
    return;
  std::string said = fmt::format(
      "records: {} of {} failed{}", verdicts["failed"].get<std::size_t>(),
      verdicts["records"].get<std::size_t>(), verdicts["dropped"] == 0 ? "" : " and are left out");
  for (const auto& [key, what] :
       {std::pair("pairs", "pairs"), std::pair("moving", "pairs with obstacles that move")}) {
    if (!verdicts.contains(key)) continue;
    said += fmt::format("; {}: {} of {} refused", what, verdicts[key]["refused"].get<std::size_t>(),
                        verdicts[key]["checked"].get<std::size_t>());
  }
  cli::tell(common, "skyway-check", said);
}

// Throws UsageError for an option that one shard cannot answer.
void refuse_together(const Options& options, bool shard) {
  if (shard && options.together.asked()) {
    throw cli::UsageError(
        "--together compares every pair of flights, and a shard has only some of them: leave "
        "--shard or --together out");
  }
  if (shard && options.together.moving().asked()) {
    throw cli::UsageError(
        "--moving gives one verdict on all flights, and a shard has only some of them: leave "
        "--shard or --moving out");
  }
  if (shard && !options.junit.empty()) {
    throw cli::UsageError(
        "--junit lists all records, and a shard has only some of them: leave --shard or --junit "
        "out");
  }
  if (shard && options.drop_refused) {
    throw cli::UsageError(
        "--drop-refused gives one verdict on all records that are left, and a shard has only some "
        "of them: leave --shard or --drop-refused out");
  }
  if (shard && options.report.asks_for_text()) {
    throw cli::UsageError(
        "--report text lists all records, and a shard has only some of them: leave --shard or "
        "--report text out");
  }
}

void begin(cli::Sharding& sharding, CLI::App& app, const Options& options) {
  sharding.begin(app,
                 {{"map", options.map},
                  {"file", options.input},
                  {"params", options.drone_file.autopilot.params},
                  {"ground", options.drone_file.terrain.file()},
                  {"plan", options.flights.plan()},
                  {"tube", options.flights.tube()},
                  {"contingencies", options.contingencies.file()}},
                 {{"output", options.report.file()},
                  {"certificate", options.certificate},
                  {"profile", options.profile.file()}});
}

// Checks what FILE holds, flight logs excepted, and writes what it comes to.
cli::Exit check_records(Options& options, cli::InputFile& file, cli::Scenes& scenes,
                        const cli::Sharding& sharding, const cli::Common& common) {
  std::optional<traj::MovingObstacles> moving;
  if (options.together.moving().asked()) {
    moving = read_moving(options.together.moving(), scenes.map(), options.metres);
  }
  if (!options.drone_file.format.empty() || options.returns.asked()) {
    options.drone_file.autopilot.settle(options.vehicle.profile());
  }
  std::optional<checking::Tubes> tubes;
  if (!options.flights.tube().empty()) {
    tubes.emplace(options.flights.tube(), scenes, options.vehicle.margin.value_or(0));
  }
  checking::Rules rules = options.rules();
  rules.tubes = tubes ? &*tubes : nullptr;
  const checking::Checker checker(common, scenes, options.profile, options.together, rules);
  checking::Reports reports(options.files(), sharding, scenes.map());
  const std::size_t total = checker.each(file, options.drone_file, sharding.shard(), reports);
  if (options.drop_refused) options.together.drop(reports.dropped());
  nlohmann::ordered_json verdicts = {{"records", reports.count()},
                                     {"failed", reports.failed()},
                                     {"dropped", reports.dropped().size()}};
  if (options.together.asked()) {
    verdicts["pairs"] =
        check_together(common, options.together, options.decides_exactly(), reports);
  }
  if (moving) {
    verdicts["moving"] =
        check_moving(common, *moving, options.together, options.decides_exactly(), reports);
  }
  const cli::Exit exit = reports.commit(total);
  if (reports.tells()) {
    reports.batch().tell(common, "skyway-check", "records failed");
    tell_verdicts(common, verdicts);
  }
  reports.beyond().tell(common, "skyway-check");
  verdicts["collision"] = scenes.stats();
  common.write_stats(verdicts);
  return exit;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Prove trajectories and paths free of collision and inside their limits.",
               "skyway-check"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({options.map, options.input, options.drone_file.autopilot.params,
                            options.flights.plan(), options.flights.tube(),
                            options.together.moving().file(), options.contingencies.file()});
    if (checking::is_folder(app, options.map)) {
      return checking::check_folder(common, options.map, options.report.file());
    }
    refuse_together(options, sharding.asked());
    const geom::BoxMap map = cli::open_map(options.map, geom::Verified::contents);
    cli::InputFile file(options.input);
    options.drone_file.settle(file);
    options.refuse_idle(app);
    options.drone_file.settle_ground(map.spec().frame);
    if (options.contingencies.asked()) {
      options.contingencies.settle(options.drone_file, options.vehicle);
    }
    begin(sharding, app, options);
    if (const auto done = sharding.finished(common)) return *done;
    using Differences = cli::Scenes::Differences;
    cli::Scenes scenes(
        map, options.vehicle,
        options.override_record ? Differences::allowed : Differences::stricter_allowed);
    if (options.flight_log()) {
      return options.flights.check({common, options.input, scenes, options.metres, sharding,
                                    options.report, options.override_record});
    }
    if (options.contingencies.asked()) {
      return options.contingencies.check({common, file, scenes, options.drone_file.autopilot,
                                          options.limits.limits()[traj::Limit::speed],
                                          options.metres, sharding, options.report, options.exact,
                                          options.certificate});
    }
    return check_records(options, file, scenes, sharding, common);
  });
}
