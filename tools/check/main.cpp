// skyway-check: prove that trajectories and paths are clear of a map and inside their limits.

#include <fmt/format.h>

#include <algorithm>

#include "checker.h"
#include "cli/batch.h"
#include "cli/option/limit_options.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "flight_logs.h"
#include "geom/map/wider_bounds.h"
#include "geom/record/agreed_room.h"
#include "together.h"
#include "traj/record/certificate_record.h"
#include "traj/record/junit_suite.h"

namespace {

struct Options {
  std::string map;
  std::string input = "-";
  std::string output = "-";
  std::string certificate;
  checking::ProfileFile profile;
  std::string junit;
  cli::VehicleOptions vehicle;
  cli::LimitOptions limits;
  bool override_record = false;
  bool exact = false;
  bool no_clearance = false;
  cli::DroneFileOptions drone_file;
  checking::Together together;
  checking::FlightLogs flights;
  cli::MetresOption metres;

  bool flight_log() const { return drone_file.is_flight_log(); }
  void add_to(CLI::App& app);
  void refuse_idle(const CLI::App& app) const;
  checking::Rules rules() const {
    return {limits.limits(),
            override_record,
            exact || !certificate.empty(),
            &drone_file.autopilot.flier,
            no_clearance ? traj::Clearance::left_out : traj::Clearance::measured,
            metres};
  }
};

void Options::add_to(CLI::App& app) {
  app.add_option("map", map, "box map; - for stdin")->required();
  app.add_option("file", input, "trajectories or paths, JSON Lines (default: stdin)");
  cli::add_output(app, "-o,--output", output, "reports (default: stdout)");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  vehicle.add_spare_to(app);
  limits.add_to(app);
  app.add_flag("--override", override_record,
               "let options and --vehicle be looser than what the records carry");
  app.add_flag("--exact", exact, "check once more in exact numbers; both must accept");
  app.add_flag("--no-clearance", no_clearance,
               "leave the clearance out of the reports: it costs more than the verdict");
  profile.add_to(app);
  cli::add_output(app, "--junit", junit, "write the verdicts as a JUnit test suite, XML");
  cli::add_output(
      app, "--certificate", certificate,
      "write the reasons why each accepted record is clear, JSON Lines; implies --exact");
  drone_file.add_to(app);
  flights.add_to(app);
  together.add_to(app);
  metres.add_to(app);
}

void Options::refuse_idle(const CLI::App& app) const {
  flights.refuse_idle(app, flight_log());
  together.refuse_idle(app, !drone_file.format.empty());
  cli::only_for(app, !profile.file().empty(), {"--profile-step"}, "--profile");
  if (drone_file.format.empty()) {
    drone_file.require_used("records", "without --file-format, FILE is read as records");
  }
  if (flight_log()) drone_file.require_used(cli::kFlightLogWord, "--file-format is flight-log");
}

// Writes what each record came to, and counts.
class Reports {
 public:
  // All must outlive this.
  Reports(Options& options, const cli::Sharding& sharding, const geom::BoxMap& map)
      : map_(map),
        profile_(options.profile),
        parks_(options.together.parks()),
        out_(options.output, "output", sharding) {
    if (!options.certificate.empty())
      certificates_.emplace(options.certificate, "certificate", sharding);
    profile_.open(sharding);
    if (!options.junit.empty()) junit_.emplace(options.junit, cli::OutputKind::text);
  }

  void add(const traj::ReportRecord& report) {
    const bool ok = traj::accepted(report);
    failed_ += !ok;
    ++count_;
    ok ? batch_.add_good()
       : batch_.add_failed(report.result.ok ? "exact" : name(report.result.reason));
    if (!ok && report.result.reason == traj::Reason::bounds) add_beyond(report);
    if (certificates_) certificates_->add(ok ? certificate(report) : std::string());
    profile_.finish_record();
    suite_.add(report, map_);
    out_.add(traj::to_json_line(report, map_));
    out_.flush();
  }

  // Of all flights against one another.
  void add(const checking::Together& together, const traj::TogetherResult& result) {
    failed_ += !result.ok() || together.left_out() > 0;
    suite_.add(result, together.task(), together.left_out());
    for (const traj::RefusedPair& pair : result.refused) {
      out_.add(traj::to_json_line(pair, together.task()));
    }
    out_.add(traj::to_json_line(result, together.task(), together.left_out()));
    if (!certificates_) return;
    for (const traj::ProvedPair& pair : result.proved) {
      certificates_->add(traj::certificate_line(pair, together.task()));
    }
    if (result.ok() && together.left_out() == 0) {
      certificates_->add(traj::certificate_line(together.task(), together.flights()));
    }
  }

  // Of all flights against obstacles that move.
  void add(const traj::MovingObstacles::Found& found) {
    failed_ += !found.summary.ok();
    suite_.add(found.conflicts, found.summary);
    for (const traj::MovingConflict& one : found.conflicts) {
      out_.add(traj::to_json_line(one, found.summary.epoch));
    }
    out_.add(traj::to_json_line(found.summary));
    if (!certificates_) return;
    for (const traj::ProvedMoving& one : found.proved) {
      certificates_->add(traj::certificate_line(one));
    }
    if (found.summary.ok()) certificates_->add(traj::certificate_line(found.claim));
  }

  // `total`: how many records all shards have.
  cli::Exit commit(std::size_t total) {
    const cli::Exit exit = failed_ ? cli::Exit::no : cli::Exit::yes;
    out_.commit(total, exit);
    if (certificates_) certificates_->commit(total, exit);
    profile_.commit(total, exit);
    if (junit_) {
      junit_->stream() << suite_.xml();
      junit_->commit();
    }
    return exit;
  }

  // What to do where records leave the bounds.
  void tell_beyond(const cli::Common& common) const {
    if (!wider_.any()) return;
    cli::tell(
        common, "skyway-check",
        fmt::format("the bounds are left, at most {}: {}", wider_.in_words(), wider_.advice()));
  }

  std::size_t count() const { return count_; }
  std::size_t failed() const { return failed_; }
  const cli::Batch& batch() const { return batch_; }

 private:
  void add_beyond(const traj::ReportRecord& report) {
    const geom::Vec3 half = report.provenance.vehicle ? report.provenance.vehicle->half
                                                      : geom::Vec3(geom::Vec3::Zero());
    const double margin = report.provenance.margin.value_or(0);
    wider_.add(report.result.place, half + geom::Vec3::Constant(margin), report.result.worst);
  }

  std::string certificate(const traj::ReportRecord& report) const {
    traj::CertificateRecord record{report.id,          report.checked,    *report.exact,
                                   map_.spec().bounds, report.provenance, report.limits,
                                   report.overridden};
    if (report.by_time) {
      record.epoch = map_.spec().epoch;
      record.start = report.time.start;
      record.stands = parks_;
    }
    return to_json_line(record);
  }

  const geom::BoxMap& map_;
  checking::ProfileFile& profile_;
  std::optional<cli::OutputFile> junit_;
  traj::JUnitSuite suite_;
  geom::WiderBounds wider_{map_.spec().bounds};  // that would hold what leaves them
  bool parks_;
  cli::RecordOutput out_;
  std::optional<cli::RecordOutput> certificates_;
  std::size_t count_ = 0;
  std::size_t failed_ = 0;
  cli::Batch batch_;
};

void check_together(const cli::Common& common, checking::Together& together, bool exact,
                    Reports& reports) {
  const traj::TogetherResult result = together.check(exact, common.execution("pairs"));
  reports.add(together, result);
  if (result.ok()) return;
  const auto nearest = std::min_element(
      result.refused.begin(), result.refused.end(),
      [](const auto& a, const auto& b) { return a.result.share < b.result.share; });
  cli::tell(common, "skyway-check",
            fmt::format("{} of {} pairs come too near; the nearest: {}", result.refused.size(),
                        result.pairs, traj::in_words(*nearest, together.task())));
}

traj::MovingObstacles read_moving(const cli::Moving& option, const geom::BoxMap& map,
                                  const cli::MetresOption& metres) {
  traj::MovingObstacles moving = option.read();
  geom::NamedMap named(map);
  moving.require_of(named, cli::look_at_boxes(metres, map.spec().frame));
  return moving;
}

void check_moving(const cli::Common& common, const traj::MovingObstacles& moving,
                  const checking::Together& together, bool exact, Reports& reports) {
  const auto found = moving.check(together.flights(), together.task(), together.left_out(), exact,
                                  common.execution("flights"));
  reports.add(found);
  if (found.conflicts.empty()) return;
  cli::tell(common, "skyway-check",
            fmt::format("{} meetings with obstacles that move; the first: {}",
                        found.conflicts.size(), traj::in_words(found.conflicts.front())));
}

// What does not go together.
void refuse_together(const Options& options, bool shard) {
  if (shard && options.together.asked()) {
    throw cli::UsageError(
        "--together holds each flight against each, and a shard holds some: leave --shard or "
        "--together out");
  }
  if (shard && options.together.moving().asked()) {
    throw cli::UsageError(
        "--moving says how all flights came out, and a shard holds some: leave --shard or "
        "--moving out");
  }
  if (shard && !options.junit.empty()) {
    throw cli::UsageError(
        "--junit says how all records came out, and a shard holds some: leave "
        "--shard or --junit out");
  }
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
    options.refuse_idle(app);
    refuse_together(options, sharding.asked());
    cli::at_most_one_stdin({options.map, options.input, options.drone_file.autopilot.params,
                            options.flights.plan(), options.flights.tube(),
                            options.together.moving().file()});
    sharding.begin(app,
                   {{"map", options.map},
                    {"file", options.input},
                    {"params", options.drone_file.autopilot.params},
                    {"plan", options.flights.plan()},
                    {"tube", options.flights.tube()}},
                   {{"output", options.output},
                    {"certificate", options.certificate},
                    {"profile", options.profile.file()}});
    const geom::BoxMap map = cli::open_map(options.map, geom::Verified::contents);
    if (const auto done = sharding.finished(common)) return *done;
    using Differences = cli::Scenes::Differences;
    cli::Scenes scenes(
        map, options.vehicle,
        options.override_record ? Differences::allowed : Differences::stricter_allowed);
    if (options.flight_log()) {
      return options.flights.check(common, options.input, scenes, options.metres, sharding,
                                   options.output);
    }
    std::optional<traj::MovingObstacles> moving;
    if (options.together.moving().asked()) {
      moving = read_moving(options.together.moving(), scenes.map(), options.metres);
    }
    if (!options.drone_file.format.empty()) {
      options.drone_file.autopilot.settle(options.vehicle.profile());
    }
    const checking::Checker checker(common, scenes, options.profile, options.together,
                                    options.rules());
    cli::InputFile file(options.input);
    Reports reports(options, sharding, scenes.map());
    const std::size_t total =
        checker.each(file, options.drone_file, sharding.shard(),
                     [&](const traj::ReportRecord& report) { reports.add(report); });
    if (options.together.asked())
      check_together(common, options.together, options.rules().exact, reports);
    if (moving) check_moving(common, *moving, options.together, options.rules().exact, reports);
    const cli::Exit exit = reports.commit(total);
    reports.batch().tell(common, "skyway-check", "records failed");
    reports.tell_beyond(common);
    common.write_stats({{"records", reports.count()},
                        {"failed", reports.failed()},
                        {"collision", scenes.stats()}});
    return exit;
  });
}
