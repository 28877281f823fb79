// skyway-fleet: departures of many flights, so that every pair keeps apart, proved.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/moving.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/spacing_options.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/text/counted.h"
#include "traj/record/verdict.h"
#include "traj/schedule/fleet_schedule.h"

namespace {

constexpr std::size_t kShown = 10;  // lines of a kind that are told
constexpr int kRescue = 20;         // rounds, as long as a flight is refused

struct Options {
  std::string input = "-";
  std::string output = "-";
  std::string report;
  std::string map;
  cli::VehicleOptions vehicle;
  cli::Moving moving;
  cli::MetresOption metres;
  std::vector<std::string> alternatives;
  std::string others;
  traj::Spacing spacing;
  traj::Parked parked = traj::Parked::pad;
  double max_delay = 600;
  traj::DepartureOptions departures{.rescue = kRescue};
  bool drop_refused = false;

  traj::Refused refused() const {
    return drop_refused ? traj::Refused::left_out : traj::Refused::kept;
  }
  void settle(const CLI::App& app) {
    if (app.count("--improve") > 0) departures.rescue = 0;
  }
  void add_to(CLI::App& app);
  void refuse_idle(const CLI::App& app) const;
};

void Options::add_to(CLI::App& app) {
  app.add_option("file", input, "trajectories, JSON Lines (default: stdin)");
  cli::add_output(app, "-o,--output", output, "the same with their departures (default: stdout)");
  cli::add_output(app, "--report-file", report, "delays, and who was refused for whom, JSON");
  app.add_option(
      "--map", map,
      "box map, whose boxes with times flights keep clear of; the flights must be proved "
      "on it but for these");
  vehicle.add_to(app);
  metres.add_to(app);
  moving.add_to(app, "flights keep clear of each at every instant, too");
  cli::add_spacing(app, spacing, parked);
  app.add_option("--max-delay", max_delay,
                 "seconds that a flight may wait after its earliest departure (default 600)")
      ->check(CLI::Range(0.0, geom::kLargestTime));
  app.add_option("--alternatives", alternatives,
                 "other ways for flights that would have to wait longer: trajectories of the same "
                 "ids, the first file first")
      ->type_name("FILE");
  app.add_option("--others", others,
                 "trajectories with a start, as another operator's: they stay as they are, and "
                 "flights keep apart from them, too")
      ->type_name("FILE");
  app.add_option("--improve", departures.improve,
                 "rounds in which flights that wait are moved forward (default: 0, and up to 20 "
                 "while a flight would be refused)")
      ->check(CLI::Range(0, 1000000));
  app.add_flag("--drop-refused", drop_refused,
               "leave flights out that have no departure, and answer for the others");
  app.add_option("--seed", departures.seed, "seed of the order of --improve (default 0)");
}

void Options::refuse_idle(const CLI::App& app) const {
  cli::only_for(app, !map.empty() || moving.asked(), {"--vehicle", "--margin"},
                "--map or --moving");
  cli::only_for(app, !map.empty(), {"--metres"}, "--map");
  cli::only_for(app, departures.improve > 0, {"--seed"}, "--improve");
  std::vector<std::string> beside = alternatives;
  for (const std::string& file : {map, others, moving.file()}) {
    if (!file.empty()) beside.push_back(file);
  }
  cli::at_most_one_stdin(input, beside);
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

traj::FleetStream read_stream(const Options& options, const cli::Common& common) {
  traj::FleetStream stream({options.max_delay, !options.spacing.zone, options.moving.asked(),
                            options.vehicle.asked(options.vehicle.profile()), options.spacing.zone},
                           {common.execution("read").threads, {}});
  cli::InputFile flights(options.input);
  stream.read(flights.stream(), flights.name());
  for (const std::string& path : options.alternatives) {
    cli::InputFile ways(path);
    stream.read_ways(ways.stream(), ways.name());
  }
  if (options.others.empty()) return stream;
  cli::InputFile others(options.others);
  stream.read_others(others.stream(), others.name());
  return stream;
}

traj::TimedMap open_map(const Options& options, const cli::Common& common) {
  return {cli::open_map(options.map, geom::Verified::contents, common.execution("verify")),
          options.map, options.vehicle.asked(options.vehicle.profile()), options.vehicle.budget(),
          common.execution("map")};
}

traj::FleetObstacles read_obstacles(const Options& options, const traj::FleetStream& stream,
                                    const cli::Common& common) {
  traj::FleetObstacles obstacles(stream, options.parked, common.execution("moving"));
  const cli::MetresOption& metres = options.metres;
  geom::Frame frame;
  if (!options.map.empty()) {
    traj::TimedMap map = open_map(options, common);
    frame = map.map().spec().frame;
    obstacles.add_map(std::move(map), [&metres, frame](const auto& trajectory, const auto& id) {
      metres.check_input(frame, trajectory, id, 0);
    });
  }
  if (options.moving.asked()) {
    obstacles.add_moving(options.moving.read(), cli::look_at_boxes(metres, frame));
  }
  return obstacles;
}

void write(const traj::FleetSchedule& schedule, const traj::FleetProof& proof,
           const Options& options) {
  cli::OutputFile out(options.output, cli::OutputKind::text);
  for (const std::string& record : schedule.records(options.refused())) {
    out.stream() << record;
  }
  out.commit();
  if (options.report.empty()) return;
  cli::OutputFile report(options.report, cli::OutputKind::text);
  report.stream() << schedule.report(proof, options.departures.improve, options.refused());
  report.commit();
}

// How the flights of the stream came out, and how those of others are among themselves.
std::string verdicts(const traj::FleetStream& stream, const traj::FleetSchedule& schedule,
                     const traj::FleetProof& proof) {
  std::string out = fmt::format("{} of {} flights depart, proved to keep apart{}",
                                schedule.departing(), stream.entries().size(),
                                stream.others() > 0 ? " from each other and from --others" : "");
  if (!proof.together.ok()) {
    out += fmt::format("; {} too near each other, which does not count here",
                       geom::counted(proof.together.refused.size(), "pair of --others is",
                                     "pairs of --others are"));
  }
  return out;
}

void tell(const cli::Common& common, const traj::FleetStream& stream,
          const traj::FleetSchedule& schedule, const traj::FleetProof& proof,
          const traj::Departures& departures) {
  cli::Batch batch;
  std::size_t shown = 0;
  for (const traj::FleetStream::Entry& entry : stream.entries()) {
    if (!entry.number) {
      batch.add_failed(name(entry.record->status),
                       entry.record->id + ": " + traj::in_words(*entry.record));
    } else if (departures.of[*entry.number].start) {
      batch.add_good();
    } else {
      batch.add_failed("refused");
      if (++shown <= kShown) {
        cli::tell(common, "skyway-fleet",
                  entry.record->id + ": " + schedule.why_refused(*entry.number));
      }
    }
  }
  batch.tell(common, "skyway-fleet", "flights have no departure");
  const auto& near = proof.together.refused;
  for (std::size_t i = 0; i < std::min(near.size(), kShown); ++i) {
    common.warn(schedule.too_near(near[i]));
  }
  if (near.size() > kShown)
    common.warn(fmt::format("and {} more such pairs", near.size() - kShown));
  if (departures.rescued > 0) {
    cli::tell(common, "skyway-fleet",
              fmt::format("{} without moving others back (--improve 0)",
                          geom::counted(departures.rescued, "flight would have no departure",
                                        "flights would have no departure")));
  }
  if (schedule.departing() < stream.entries().size() || !near.empty()) {
    cli::tell(common, "skyway-fleet", verdicts(stream, schedule, proof));
  }
}

// Reads, chooses, proves and writes.
cli::Exit schedule_fleet(const Options& options, const cli::Common& common) {
  Clock clock;
  const traj::FleetStream stream = read_stream(options, common);
  std::vector<traj::FleetFlight> flights = stream.flights();
  traj::FleetObstacles obstacles = read_obstacles(options, stream, common);
  obstacles.close(flights);
  const double read_s = clock.lap();
  const traj::FleetConflicts conflicts =
      traj::fleet_conflicts(flights, options.spacing, options.parked, common.execution("pairs"));
  const double pairs_s = clock.lap();
  const traj::Departures departures =
      traj::choose_departures(flights, conflicts, options.departures, common.execution("rounds"));
  const double choose_s = clock.lap();
  const traj::FleetSchedule schedule({stream, obstacles, flights, conflicts, departures},
                                     options.spacing, options.parked);
  const traj::FleetProof proof = schedule.prove(common.execution("proof"));
  const double prove_s = clock.lap();
  write(schedule, proof, options);
  tell(common, stream, schedule, proof, departures);
  common.write_stats({{"flights", flights.size()},
                      {"departing", schedule.departing()},
                      {"refused", schedule.refused()},
                      {"left_out", schedule.without()},
                      {"dropped", options.drop_refused},
                      {"others_too_near", proof.together.refused.size()},
                      {"near", conflicts.looked_at},
                      {"conflicting", conflicts.pairs.size()},
                      {"read_s", read_s},
                      {"pairs_s", pairs_s},
                      {"choose_s", choose_s},
                      {"prove_s", prove_s},
                      {"write_s", clock.lap()}});
  return schedule.ok(options.refused()) ? cli::Exit::yes : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Choose departures of many flights, so that every pair keeps apart, and prove them.",
               "skyway-fleet"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.refuse_idle(app);
    options.settle(app);
    return schedule_fleet(options, common);
  });
}
