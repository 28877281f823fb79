// skyway-plot: SVG pictures of maps with paths, of motion, of ways home, and of benchmarks.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/content/contents.h"
#include "cli/file/ending.h"
#include "cli/file/files.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/figure/plan_view.h"
#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "plan/bench/compared_figure.h"
#include "tracks.h"
#include "traj/curve/to_enu.h"
#include "traj/figure/fleet.h"
#include "traj/figure/home.h"
#include "traj/figure/motion_profile.h"
#include "traj/figure/tracking.h"
#include "traj/proof/domain.h"
#include "traj/record/tube_reports.h"

namespace {

struct Options {
  explicit Options(const cli::Common& shared) : common(shared) {}

  const cli::Common& common;
  std::string map;
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string id;
  double within = 0;  // metres; 0: as far as some pairs are
  cli::VehicleOptions vehicle;
  cli::MetresOption metres;
};

constexpr double kFarthest = 200;  // metres: pairs that are farther apart are not looked for

// What there is to draw of the inputs, all made for `map` where one is given.
cli::Contents read(const Options& options, const geom::BoxMap* map,
                   const cli::ContentKinds& kinds = {}) {
  cli::Contents contents = cli::read_contents(options.inputs, kinds);
  if (map) cli::require_same_map(contents, map, options.metres);
  if (map) cli::warn_of_unsaid_maps(options.common, contents);
  cli::tell_left_out(options.common, "skyway-plot", cli::drop_failed(contents));
  const auto other = [&](const auto& read) {
    return !options.id.empty() && read.record.id != options.id;
  };
  std::erase_if(contents.paths, other);
  std::erase_if(contents.trajectories, other);
  std::erase_if(contents.flights, other);
  return contents;
}

template <class List>
const auto& first_of(const List& list, const Options& options, const char* what) {
  if (list.empty()) {
    throw geom::InputError(options.inputs[0] == "-" ? "stdin" : options.inputs[0],
                           {.expected = std::string(what), .found = "none"});
  }
  return list.front();
}

// The first of the list, and what the title says of the others.
template <class Record>
struct Drawn {
  const Record& record;
  std::string note;
};

template <class Record>
Drawn<Record> one_of(const std::vector<cli::Read<Record>>& list, const Options& options,
                     const char* what) {
  const Record& first = first_of(list, options, what).record;
  if (list.size() == 1) return {first, ""};
  cli::tell(options.common, "skyway-plot",
            fmt::format("draws \"{}\", the first of {}: --id names another",
                        geom::excerpt(first.id), list.size()));
  return {first, fmt::format(" (the first of {})", list.size())};
}

std::string plan(const Options& options) {
  const geom::BoxMap map = cli::open_map(options.map, geom::Verified::extents);
  const cli::Contents contents = read(options, &map);
  const geom::Axes axes = map.spec().frame.axes;
  return geom::figure::plan_view(map, plot::plan_trees(contents, axes),
                                 plot::plan_lines(contents, axes));
}

std::string profile(const Options& options) {
  const cli::Contents contents = read(options, nullptr);
  const auto drawn = one_of(contents.trajectories, options, "a solved trajectory");
  return traj::figure::motion_profile(drawn.record, drawn.note);
}

// The trajectory of the flight's id, else the first, which is told where there are others.
const traj::TrajectoryRecord& plan_of(const traj::FlightLog& flight, const Options& options,
                                      const cli::Contents& contents) {
  for (const auto& read : contents.trajectories) {
    if (read.record.id == flight.id) return read.record;
  }
  return one_of(contents.trajectories, options, "a trajectory").record;
}

// The tube of the plan, from reports of skyway-fly; null where none is of it.
const traj::TubeRecord* tube_of(const traj::TrajectoryRecord& plan, const Options& options,
                                const cli::Contents& contents) {
  const geom::Provenance over{.frame = plan.provenance.frame.value_or(geom::Axes::enu),
                              .vehicle = plan.provenance.vehicle};
  for (const auto& [tube, source, line] : contents.tubes) {
    if (tube.id == plan.id && !traj::why_not_of(tube, plan.trajectory, over)) return &tube;
  }
  if (!contents.tubes.empty()) {
    cli::tell(options.common, "skyway-plot",
              "draws no tube: none of the reports is of " + geom::excerpt(plan.id));
  }
  return nullptr;
}

std::string tracking(const Options& options) {
  const cli::Contents contents = read(
      options, nullptr, {.reports = true, .expected = "a trajectory or a report of skyway-fly"});
  const auto drawn = one_of(contents.flights, options, "a flight log");
  if (contents.trajectories.empty()) return traj::figure::tracking(drawn.record, drawn.note);
  cli::require_same_map(contents, nullptr);
  const traj::TrajectoryRecord& plan = plan_of(drawn.record, options, contents);
  const traj::Trajectory enu =
      traj::to_enu(plan.provenance.frame.value_or(geom::Axes::enu), plan.trajectory);
  return traj::figure::tracking(drawn.record, drawn.note, &enu, tube_of(plan, options, contents));
}

// What the title says of paths that are not drawn, because what moves is.
std::string paths_left_out(const cli::Contents& contents, const Options& options) {
  if (contents.paths.empty() || contents.trajectories.size() + contents.flights.size() == 0) {
    return "";
  }
  const std::string paths = geom::counted(contents.paths.size(), "path");
  cli::tell(
      options.common, "skyway-plot",
      fmt::format("draws trajectories and flights over time and leaves out {}: draw paths alone",
                  paths));
  return fmt::format(" ({} left out)", paths);
}

std::string clearance(const Options& options) {
  cli::Scenes scenes(cli::open_map(options.map, geom::Verified::extents), options.vehicle,
                     cli::Scenes::Differences::allowed);
  const cli::Contents contents = read(options, &scenes.map());
  if (scenes.map().size() == 0) {
    throw geom::InputError(options.map, {.expected = "a map with obstacles", .found = "none"});
  }
  if (contents.paths.empty() && contents.trajectories.empty()) {
    first_of(contents.flights, options, "a path, a trajectory or a flight");
  }
  const geom::CollisionScene& scene =
      scenes.scene_for(plot::provenance_of(contents), options.inputs[0], 0);
  const auto require_same_room = [&](const auto& list) {
    for (const auto& [record, source, line] : list) {
      scenes.require_same_room(record.provenance, source, line);
    }
  };
  require_same_room(contents.trajectories);
  if (contents.trajectories.empty() && contents.flights.empty()) require_same_room(contents.paths);
  const plot::Tracks tracks = plot::tracks_of(contents, scene);
  first_of(tracks.list, options, "a path, a trajectory or a flight of some length");
  return traj::figure::clearance(scene, tracks.list, tracks.x_label,
                                 paths_left_out(contents, options));
}

std::string bench(const Options& options) {
  std::vector<plan::bench::ShownReport> reports;
  for (const std::string& input : options.inputs) {
    cli::InputFile file(input);
    const geom::JsonFields fields(file.read_all(), file.name(), 0);
    reports.push_back(
        plan::bench::parse_report(fields, std::filesystem::path(file.name()).stem().string()));
  }
  return plan::bench::compared_figure(reports);
}

std::string fleet(const Options& options) {
  const cli::Contents contents = read(options, nullptr);
  cli::require_same_map(contents, nullptr);
  const auto& first = first_of(contents.trajectories, options, "solved trajectories").record;
  std::vector<traj::figure::FleetFlight> flights;
  std::vector<traj::TimedFlight> timed;
  for (const auto& [record, source, line] : contents.trajectories) {
    geom::require_epoch_agrees(record.time.epoch, first.time.epoch, source, line);
    if (traj::outside_domain(record.trajectory, {})) {
      throw geom::InputError(source, line,
                             {.expected = "a trajectory that can be flown",
                              .found = "one with times or coordinates out of range"});
    }
    const double start = record.time.starts();
    flights.push_back({record.id, start, traj::duration(record.trajectory), {}});
    if (record.time.start && record.time.earliest) {
      flights.back().delay = start - *record.time.earliest;
    }
    timed.push_back({&record.trajectory, start, geom::Vec3::Zero()});
  }
  const geom::Execution run = options.common.execution("pairs");
  traj::Approaches approaches{options.within, {}};
  if (options.within > 0) {
    approaches.list = traj::nearest_approaches(timed, options.within, run);
  } else {
    approaches = traj::nearest_approaches(timed, 2 * timed.size(), kFarthest, run);
  }
  return traj::figure::fleet(flights, approaches);
}

std::string home(const Options& options) {
  const cli::ContentKinds kinds{.reports = true,
                                .contingencies = true,
                                .expected = "a report, a way home, a trajectory or a flight log"};
  cli::Contents contents = cli::read_contents(options.inputs, kinds);
  cli::require_same_map(contents, nullptr);
  cli::tell_left_out(options.common, "skyway-plot", cli::drop_failed(contents));
  std::vector<traj::figure::HomeFlight> flights =
      plot::home_flights(contents, options.id.empty() ? std::nullopt : std::optional(options.id));
  first_of(flights, options,
           "reports with returns (skyway-check --return) or planned ways home (skyway-plan "
           "--home)");
  return flights.size() == 1 ? traj::figure::home(flights.front()) : traj::figure::homes(flights);
}

struct Verb {
  CLI::App* app;
  std::string (*draw)(const Options&);
};

CLI::App* add_verb(CLI::App& app, Options& options, const char* name, const char* what) {
  CLI::App* verb = app.add_subcommand(name, what);
  verb->fallthrough();
  cli::add_output(*verb, "-o,--output", options.output, "SVG to write (default: stdout)");
  return verb;
}

std::vector<Verb> add_verbs(CLI::App& app, Options& options) {
  const auto add = [&](const char* name, const char* what) {
    return add_verb(app, options, name, what);
  };
  CLI::App* plan_verb =
      add("plan", "a map from above, with paths, trajectories, flights and trees");
  CLI::App* profile_verb = add("profile", "position, speed, acceleration, jerk, thrust and tilt");
  CLI::App* tracking_verb = add("tracking", "a flight beside its setpoints");
  CLI::App* clearance_verb = add("clearance", "distance to the obstacles along the way");
  CLI::App* bench_verb = add("bench", "times and lengths of planners");
  CLI::App* home_verb = add("home", "from which instants there is a way home, and why not");
  CLI::App* fleet_verb = add("fleet", "delays, least distances of pairs, flights in the air");
  for (CLI::App* verb : {plan_verb, clearance_verb}) {
    verb->add_option("map", options.map, "box map; - for stdin")->required();
  }
  plan_verb->add_option("files", options.inputs, "what to draw on it; - for stdin");
  profile_verb->add_option("file", options.inputs, "trajectories; the first solved one is drawn")
      ->required();
  tracking_verb
      ->add_option("file", options.inputs,
                   "flight log, the first flight of which is drawn, and perhaps the "
                   "trajectory that it was to follow")
      ->required();
  clearance_verb->add_option("files", options.inputs, "paths, or trajectories and flights")
      ->required();
  bench_verb->add_option("reports", options.inputs, "reports of skyway-bench")->required();
  home_verb
      ->add_option("files", options.inputs,
                   "reports of skyway-check --return, ways home of skyway-plan --home, and "
                   "trajectories or flights for the height")
      ->required();
  fleet_verb->add_option("files", options.inputs, "trajectories; - for stdin")->required();
  fleet_verb
      ->add_option(
          "--nearer-than", options.within,
          "pairs that come nearer than this, metres (default: as far as there are twice as "
          "many pairs as flights, at most 200)")
      ->check(CLI::Range(1e-3, 10000.0));
  for (CLI::App* verb : {plan_verb, profile_verb, tracking_verb, clearance_verb, home_verb}) {
    verb->add_option("--id", options.id, "only this one");
  }
  for (CLI::App* verb : {plan_verb, clearance_verb}) options.metres.add_to(*verb);
  options.vehicle.add_to(*clearance_verb);
  options.vehicle.add_memory_to(*clearance_verb);
  return {{plan_verb, plan},         {profile_verb, profile},
          {tracking_verb, tracking}, {clearance_verb, clearance},
          {bench_verb, bench},       {fleet_verb, fleet},
          {home_verb, home}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draw maps, motion, ways home and benchmarks as SVG.", "skyway-plot"};
  cli::Common common(app);
  Options options(common);
  const std::vector<Verb> verbs = add_verbs(app, options);
  app.require_subcommand(1);
  return cli::run_tool(app, argc, argv, [&] {
    cli::require_ending("-o", options.output, {".svg"},
                        ": rsvg-convert makes a PNG or a PDF of x.svg (rsvg-convert x.svg -o "
                        "x.png), and so does printing it from a browser");
    cli::at_most_one_stdin(options.map, options.inputs);
    const auto asked =
        std::find_if(verbs.begin(), verbs.end(), [](const Verb& v) { return v.app->parsed(); });
    const std::string svg = asked->draw(options);
    cli::OutputFile out(options.output, cli::OutputKind::text);
    out.stream() << svg;
    out.commit();
    return cli::Exit::yes;
  });
}
