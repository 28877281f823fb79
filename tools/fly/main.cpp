// skyway-fly: how a quadrotor follows trajectories, in wind and with which gains.

#include <fmt/format.h>

#include <filesystem>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/shard/record_output.h"
#include "geom/base/text_stream.h"
#include "geom/base/thread_seconds.h"
#include "options.h"
#include "traj/flight/gains_record.h"
#include "traj/record/simulated_flights.h"
#include "traj/record/verdict.h"

namespace {

// One file alone is the map where it is a box map (a ZIP), else the trajectories.
struct Inputs {
  std::string map;  // may be empty
  std::string trajectories = "-";
};

Inputs inputs_of(const std::vector<std::string>& files) {
  if (files.empty()) return {};
  if (files.size() == 2) return {files[0], files[1]};
  if (files[0] == "-") return {};
  if (!std::filesystem::is_regular_file(files[0])) return {"", files[0]};  // no map comes by a pipe
  cli::InputFile file(files[0]);
  const bool zip = file.stream().get() == 'P' && file.stream().get() == 'K';
  return zip ? Inputs{files[0], "-"} : Inputs{"", files[0]};
}

// The files to write; empty: not asked for.
struct Outputs {
  std::string log = "-";  // or gains
  std::string report;
  std::string certificate;

  void add_to(CLI::App& app) {
    cli::add_output(app, "-o,--output", log,
                    "flight log, CSV; with --tune gains (default: stdout)");
    cli::add_output(app, "--report-file", report, "reports of the flights, JSON Lines");
    cli::add_output(app, "--certificate", certificate,
                    "with --proved-tube: why each tube holds, JSON Lines (docs/certificates.md)");
  }
};

// What must not be asked together.
void check_usage(const fly::Options& options, const Inputs& inputs, const Outputs& outputs) {
  cli::at_most_one_stdin({inputs.map, inputs.trajectories});
  const bool tube = options.runs > 0 || options.proved_tube;
  if (options.tube && (!tube || inputs.map.empty())) {
    throw cli::UsageError("--clear-tube needs a map and --runs or --proved-tube");
  }
  const bool reports = !outputs.report.empty() || !outputs.certificate.empty();
  if (options.tune && (tube || reports)) {
    throw cli::UsageError(
        "--tune writes gains: it takes no --runs, --proved-tube, --report-file or --certificate");
  }
  if (options.tune && options.proves() && options.flown.controller != traj::ControlLaw::geometric) {
    throw cli::UsageError(
        "--tune --cost proved-tube tunes the geometric controller: give --controller geometric");
  }
  if (tube && !reports) {
    throw cli::UsageError(
        options.proved_tube
            ? "--proved-tube: give --report-file or --certificate, which get the radius"
            : "--runs: give --report-file, which gets their tube");
  }
  if (!outputs.certificate.empty() && !options.proved_tube) {
    throw cli::UsageError("--certificate: give --proved-tube, of whose proof it is");
  }
  if (options.runs > 0 && std::abs(options.flown.mass_error) >= 1) {
    throw cli::UsageError("--mass-error must be below 1 with --runs");
  }
}

// What must not be asked alone.
void check_needs(const CLI::App& app, const fly::Options& options, const Inputs& inputs,
                 const cli::VehicleOptions& vehicle) {
  cli::only_for(app, options.tune, {"--cost"}, "--tune");
  cli::SimulatedVehicleOptions::refuse_idle_disturbances(app, options.proves());
  cli::only_for(app, !inputs.map.empty(), {"--metres", "--margin"}, "flights over a map");
  if (!vehicle.word.empty()) return;
  throw cli::UsageError("no vehicle: give --vehicle, such as tello or FILE.json");
}

// "0.0118" or, where a flight was lost or a tube not proved, that.
std::string shown(const std::optional<double>& cost, const fly::Options& options) {
  if (cost) return fmt::format("{:.4g}", *cost);
  return options.tunes_tube() ? "no proof" : "a lost flight";
}

void write_gains(const cli::Common& common, const traj::SimulatedFlights& mission,
                 const fly::Options& options, const std::string& output) {
  cli::OutputFile out(output, cli::OutputKind::text);
  const traj::TuneResult tuned =
      options.tunes_tube() ? mission.tune_tube(common.execution("rounds"))
                           : mission.tune(options.flight_cost(), common.execution("flights"));
  out.stream() << traj::to_json(tuned.gains);
  out.commit();
  common.note(
      fmt::format("cost ({}) before: {}, after: {}{}\n", options.cost, shown(tuned.before, options),
                  shown(tuned.cost, options),
                  tuned.improved ? "" : "; no better gains were found, so none were changed"));
  nlohmann::ordered_json stats = {{"flights", tuned.flights},
                                  {"velocity_cost", tuned.velocity_cost},
                                  {"before", nullptr},
                                  {"cost", nullptr},
                                  {"improved", tuned.improved}};
  if (tuned.before) stats["before"] = *tuned.before;
  if (tuned.cost) stats["cost"] = *tuned.cost;
  common.write_stats(stats);
}

// Log and reports of what is flown, and what it came to.
class Flights {
 public:
  Flights(const Outputs& outputs, const cli::Sharding& sharding, const traj::Airframe& airframe,
          const geom::BoxMap* map)
      : out_(outputs.log, "output", sharding), airframe_(airframe), map_(map) {
    if (!outputs.report.empty()) told_.emplace(outputs.report, "report-file", sharding);
    if (!outputs.certificate.empty()) {
      certificates_.emplace(outputs.certificate, "certificate", sharding);
    }
    geom::TextOutput head;
    traj::write_flight_log_header(head);
    out_.head(head.str());
  }

  void add(const traj::SimulatedFlight& flight) {
    geom::TextOutput rows;
    traj::write_flight(rows, flight.log);
    out_.add(rows.str());
    if (told_) told_->add(traj::to_json_line(flight.report, airframe_, map_));
    if (certificates_) certificates_->add(flight.certificate);
    ++records_;
    if (flight.seconds) {
      flown_ += *flight.seconds;
      cpu_ += flight.cpu;
    }
    if (traj::accepted(flight.report)) {
      batch_.add_good();
    } else {
      ++failed_;
      batch_.add_failed(traj::reason(flight.report),
                        flight.report.id + ": " + traj::in_words(flight.report, map_));
    }
  }

  // `total`: how many trajectories all shards have.
  cli::Exit commit(const cli::Common& common, std::size_t total) {
    const cli::Exit exit = failed_ ? cli::Exit::no : cli::Exit::yes;
    out_.commit(total, exit);
    if (told_) told_->commit(total, exit);
    if (certificates_) certificates_->commit(total, exit);
    batch_.tell(common, "skyway-fly", "flights failed");
    common.write_stats({{"records", records_},
                        {"failed", failed_},
                        {"flown_s", flown_},
                        {"cpu_s", cpu_},
                        {"times_real_time", cpu_ > 0 ? flown_ / cpu_ : 0}});
    return exit;
  }

 private:
  cli::RecordOutput out_;
  std::optional<cli::RecordOutput> told_;
  std::optional<cli::RecordOutput> certificates_;
  const traj::Airframe& airframe_;
  const geom::BoxMap* map_;
  cli::Batch batch_;
  std::size_t records_ = 0;
  std::size_t failed_ = 0;
  double flown_ = 0;  // s of simulated flight, hovering included
  double cpu_ = 0;    // s that simulating it took, of all threads
};

traj::SimulationOptions simulation(const fly::Options& options, const cli::VehicleOptions& vehicle,
                                   bool certificate) {
  const traj::VehicleProfile profile = *vehicle.profile();
  traj::SimulationOptions out{profile, options.flight(profile)};
  if (options.runs > 0) out.spread = options.spread();
  if (options.proves()) out.disturbances = options.flown.disturbances(out.flight);
  out.certificate = certificate;
  out.tube = options.tube;
  out.log_period = options.log_period();
  out.clock = geom::thread_seconds;
  return out;
}

// The margin of a record was kept for what happens here.
cli::VehicleOptions flown_as(cli::VehicleOptions vehicle) {
  vehicle.margin = vehicle.margin.value_or(0);
  return vehicle;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Fly trajectories with a simulated quadrotor.", "skyway-fly"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  fly::Options options;
  std::vector<std::string> files;
  Outputs outputs;
  app.add_option("map_and_file", files,
                 "box map, then trajectories (default: stdin); without a map, trajectories alone")
      ->expected(0, 2);
  outputs.add_to(app);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app)->excludes("--tune");
  return cli::run_tool(app, argc, argv, [&] {
    const Inputs inputs = inputs_of(files);
    check_usage(options, inputs, outputs);
    check_needs(app, options, inputs, vehicle);
    sharding.begin(app, {{"map", inputs.map}, {"trajectories", inputs.trajectories}},
                   {{"output", outputs.log},
                    {"report-file", outputs.report},
                    {"certificate", outputs.certificate}});
    std::optional<geom::BoxMap> map;
    if (!inputs.map.empty()) {
      map = cli::open_map(inputs.map, geom::Verified::contents, common.execution("verify"));
    }
    if (const auto done = sharding.finished(common)) return *done;
    if (map && options.runs > 0 && !options.tube) {
      common.warn("the runs are not held against the map: --clear-tube asks that of their tube");
    }
    std::optional<cli::Scenes> scenes;
    if (map) scenes.emplace(*map, flown_as(vehicle), cli::Scenes::Differences::allowed);
    const traj::SimulationOptions asked =
        simulation(options, vehicle, !outputs.certificate.empty());
    traj::SimulatedFlights mission(asked, scenes ? &*scenes : nullptr);
    cli::InputFile file(inputs.trajectories);
    const std::size_t total =
        mission.read(file.stream(), file.name(), sharding.shard(),
                     [&](const traj::Trajectory& trajectory, std::size_t line) {
                       options.metres.check_input(map->spec().frame, trajectory, file.name(), line);
                     });
    if (options.tune) {
      write_gains(common, mission, options, outputs.log);
      return cli::Exit::yes;
    }
    Flights flights(outputs, sharding, asked.profile.airframe, mission.map());
    mission.fly(common.execution("flights"),
                [&](const traj::SimulatedFlight& flight) { flights.add(flight); });
    return flights.commit(common, total);
  });
}
