// skyway-fleet: departures of many flights, so that every pair keeps apart, proved.

#include <fmt/format.h>

#include <chrono>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "cli/shard/departure_shard.h"
#include "cli/tell.h"
#include "schedule.h"
#include "stream.h"
#include "timed_map.h"

namespace {

struct Options {
  std::string input = "-";
  std::string output = "-";
  std::string report;
  std::string map;
  cli::VehicleOptions vehicle;
  std::vector<std::string> alternatives;
  traj::Spacing spacing;
  traj::Parked parked = traj::Parked::pad;
  double max_delay = 600;
  traj::DepartureOptions departures;

  void add_to(CLI::App& app);
};

void Options::add_to(CLI::App& app) {
  app.add_option("file", input, "trajectories, JSON Lines (default: stdin)");
  cli::add_output(app, "-o,--output", output, "the same with their departures (default: stdout)");
  cli::add_output(app, "--report", report, "delays, and who was refused for whom, JSON");
  app.add_option(
      "--map", map,
      "box map, whose boxes with times flights keep clear of; the flights must be proved "
      "on it but for these");
  vehicle.add_to(app);
  cli::add_spacing(app, spacing, parked);
  app.add_option("--max-delay", max_delay,
                 "seconds that a flight may wait after its earliest departure (default 600)")
      ->check(CLI::Range(0.0, geom::kLargestTime));
  app.add_option("--alternatives", alternatives,
                 "other ways for flights that would have to wait longer: trajectories of the same "
                 "ids, the first file first")
      ->type_name("FILE");
  app.add_option("--improve", departures.improve,
                 "rounds in which flights that wait are moved forward (default 0)")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--seed", departures.seed, "seed of the order of --improve (default 0)");
}

// Seconds since it was made, and since it was asked last.
class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> out = now - last_;
    last_ = now;
    return out.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

fleet::Stream read_stream(const Options& options) {
  fleet::Stream stream({options.max_delay, !options.spacing.zone});
  stream.read(options.input);
  for (const std::string& file : options.alternatives) stream.read_ways(file);
  return stream;
}

// Nothing is written that is not proved.
traj::TogetherResult prove(const fleet::Schedule& schedule, const Options& options,
                           const geom::Execution& run) {
  const std::vector<traj::TimedFlight> timed = schedule.timed();
  traj::TogetherResult proof = traj::check_together(timed, {options.spacing, options.parked}, run);
  if (proof.ok()) return proof;
  throw std::runtime_error(
      fmt::format("the departures that were chosen could not be proved: {} pairs are too near, or "
                  "within rounding of it; nothing was written",
                  proof.refused.size()));
}

void write(const fleet::Schedule& schedule, const traj::TogetherResult& proof,
           const Options& options) {
  cli::OutputFile out(options.output, cli::OutputKind::text);
  for (const std::string& record : schedule.records()) out.stream() << record;
  out.commit();
  if (options.report.empty()) return;
  cli::OutputFile report(options.report, cli::OutputKind::text);
  report.stream() << schedule.report(proof, options.departures.improve);
  report.commit();
}

void tell(const cli::Common& common, const fleet::Stream& stream, const fleet::Schedule& schedule,
          const traj::Departures& departures) {
  cli::Batch batch;
  std::size_t shown = 0;
  for (const fleet::Stream::Entry& entry : stream.entries()) {
    if (!entry.number) {
      batch.add_failed(name(entry.record->status));
    } else if (departures.of[*entry.number].start) {
      batch.add_good();
    } else {
      batch.add_failed("refused");
      if (++shown <= 10) {
        cli::tell(common, "skyway-fleet",
                  entry.record->id + ": " + schedule.why_refused(*entry.number));
      }
    }
  }
  batch.tell(common, "skyway-fleet", "flights have no departure");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Choose departures of many flights, so that every pair keeps apart, and prove them.",
               "skyway-fleet"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  sharding.add_join_to(app, "all shards of the pairs, which are then read and not worked out")
      ->expected(1, -1);
  return cli::run_tool(app, argc, argv, [&] {
    cli::only_for(app, !options.map.empty(), {"--vehicle", "--margin"}, "--map");
    std::vector<std::string> others = options.alternatives;
    if (!options.map.empty()) others.push_back(options.map);
    cli::at_most_one_stdin(options.input, others);
    cli::Sharding::Files inputs{{"file", options.input}};
    for (const std::string& file : options.alternatives) {
      inputs.emplace_back(fmt::format("alternatives {}", inputs.size()), file);
    }
    if (!options.map.empty()) inputs.emplace_back("map", options.map);
    if (sharding.asked() && !options.report.empty()) {
      throw cli::UsageError("a shard has no output but -o: give --report later, with --join");
    }
    sharding.begin(app, inputs, {{"output", options.output}});
    if (const auto done = sharding.finished(common)) return *done;
    Clock clock;
    const fleet::Stream stream = read_stream(options);
    std::vector<traj::FleetFlight> flights = stream.flights();
    std::optional<fleet::TimedMap> map;
    if (!options.map.empty()) {
      map.emplace(options.map, options.vehicle, common).close(stream, options.parked, flights);
    }
    const double read_s = clock.lap();
    const std::vector<cli::ShardFile> shards = sharding.shards();
    const traj::FleetConflicts conflicts =
        shards.empty() ? traj::fleet_conflicts(flights, options.spacing, options.parked,
                                               sharding.shard(), common.execution("pairs"))
                       : cli::joined_departures(shards, flights.size());
    const double pairs_s = clock.lap();
    if (sharding.asked()) {
      cli::write_shard(sharding, options.output, conflicts, flights.size());
      common.write_stats({{"near", conflicts.looked_at}, {"pairs_s", pairs_s}});
      return cli::Exit::yes;
    }
    const traj::Departures departures =
        traj::choose_departures(flights, conflicts, options.departures);
    const double choose_s = clock.lap();
    const fleet::Schedule schedule({stream, flights, conflicts, departures}, options.spacing,
                                   options.parked);
    const traj::TogetherResult proof = prove(schedule, options, common.execution("proof"));
    if (map) map->prove(stream, flights, departures, options.parked);
    const double prove_s = clock.lap();
    write(schedule, proof, options);
    tell(common, stream, schedule, departures);
    common.write_stats({{"flights", flights.size()},
                        {"near", conflicts.looked_at},
                        {"conflicting", conflicts.pairs.size()},
                        {"read_s", read_s},
                        {"pairs_s", pairs_s},
                        {"choose_s", choose_s},
                        {"prove_s", prove_s},
                        {"write_s", clock.lap()}});
    return schedule.refused() + schedule.without() > 0 ? cli::Exit::no : cli::Exit::yes;
  });
}
