// skyway-export: drone files of trajectories and paths, read back and proved as the drone will fly
// them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <list>
#include <optional>
#include <utility>

#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "dji_options.h"
#include "flight.h"
#include "geom/base/error.h"
#include "output_names.h"
#include "prove.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/straight_legs.h"
#include "writer.h"

namespace {

using exporting::Flight;
using exporting::OutputNames;
using exporting::Task;
using exporting::Written;

nlohmann::ordered_json statistics(const Task& task, const Written& written) {
  nlohmann::ordered_json stats = {{"format", task.format}, {"bytes", written.text.size()}};
  if (task.format != "crazyflie") return stats;
  const traj::CrazyflieMemory memory = traj::crazyflie_memory(task.enu);
  stats["segments"] = task.enu.segments.size();
  stats["memory"] = memory.bytes;
  stats["memory_fits"] = memory.fits;
  stats["compressed_memory"] = memory.compressed_bytes;
  stats["compressed_fits"] = memory.compressed_fits;
  return stats;
}

void warn_of_memory(const cli::Common& common, const Task& task) {
  const traj::CrazyflieMemory memory = traj::crazyflie_memory(task.enu);
  if (memory.fits) return;
  common.warn(fmt::format(
      "{}: {} segments; a Crazyflie's memory holds {}{}", task.id, task.enu.segments.size(),
      traj::kCrazyflieSegments,
      memory.compressed_fits
          ? fmt::format(" (compressed they take {} of its 4096 bytes)", memory.compressed_bytes)
          : ", nor do they fit compressed"));
}

// Straight legs end in rests of their own, not in those of the record.
void warn_of_what_is_left_out(const cli::Common& common, const Task& task, const Flight& flight) {
  if (flight.time.any()) {
    common.warn(fmt::format("{}: it begins {:.6g} s after the epoch; a {} file does not say when",
                            task.id, flight.time.starts(), task.format));
  }
  if (!exporting::has_legs(task.format)) return;
  if (flight.holds > 0) {
    common.warn(
        fmt::format("{}: it stands still for {:.4g} s in all; a {} file has no such pauses, "
                    "so they are left out",
                    task.id, flight.holds, task.format));
  }
  if (flight.has_velocities) {
    common.warn(
        fmt::format("{}: a {} file has no velocities at points, so those of the path are left out",
                    task.id, task.format));
  }
}

void set_ground(const geom::CollisionScene& scene, const Flight& flight, Task& task) {
  const auto& segments = flight.trajectory.segments;
  task.ground =
      task.placement.ground.value_or(traj::ground_below(scene, segments.front().point.front()));
  task.landing = traj::ground_below(scene, segments.back().point.back());
}

struct Options {
  std::vector<std::string> files;
  std::string output = "-";
  std::string python;  // of a Tello, beside its script; empty: not asked for
  std::string table;
  std::string id;
  std::string axes = "enu";
  bool unchecked = false;
  bool hover = false;
  cli::VehicleOptions vehicle;

  std::string input() const { return files.size() > map_files() ? files.back() : "-"; }
  std::size_t map_files() const { return unchecked ? 0 : 1; }

  void require_sound() const {
    if (files.empty() && !unchecked) throw cli::UsageError("map is required (or --unchecked)");
    if (files.size() > map_files() + 1) throw cli::UsageError("--unchecked takes no map");
    if (!unchecked) cli::at_most_one_stdin({files[0], input()});
    const std::string outputs[] = {output, python, table};
    if (std::count(std::begin(outputs), std::end(outputs), "-") > 1) {
      throw cli::UsageError("the script, --python and --table cannot share stdout");
    }
    const bool each = OutputNames(output, "--output").each();
    for (const auto& [name, option] :
         {std::pair(python, "--python"), std::pair(table, "--table")}) {
      if (!name.empty() && OutputNames(name, option).each() != each) {
        throw cli::UsageError(
            fmt::format("--output and {}: expected %s in both or in neither, found \"{}\" and "
                        "\"{}\"",
                        option, output, name));
      }
    }
  }
};

void add_options(CLI::App& app, Options& options, Task& task) {
  app.add_option("map_and_file", options.files,
                 "box map, then trajectories or paths (default: stdin); with "
                 "--unchecked no map")
      ->expected(0, 2);
  app.add_option("--format", task.format, "what to write")
      ->required()
      ->check(CLI::IsMember({"tello", "crazyflie", "qgc-plan", "wpl", "dji-wpml", "setpoints",
                             "kml", "geojson", "gltf"}));
  app.add_option("--rate", task.rate, "setpoints: how many a second, Hz (default 50)")
      ->check(CLI::Range(0.1, 10000.0));
  app.add_option("--axes", options.axes, "setpoints: axes, enu or ned (default enu)")
      ->check(CLI::IsMember({"enu", "ned"}));
  app.add_option("--tolerance", task.tolerance,
                 "how far straight legs may be from the curve, metres (default 0.2); while the "
                 "check refuses them, their points are moved off obstacles, and this is halved; "
                 "how far the points of a path may be moved")
      ->check(CLI::Range(1e-3, 100.0));
  app.add_option("--speed", task.speed,
                 "m/s along straight legs (default: what the limits allow; a Tello's are flown at "
                 "0.1 to 1, its default is 1 where the limits allow it)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_flag("--hover", options.hover, "end a mission hovering, without landing");
  exporting::add_dji_options(app, task.dji, task.turns);
  task.placement.add_to(app);
  app.add_option("--id", options.id, "which record of the stream (default: its only one)");
  app.add_flag("--unchecked", options.unchecked, "write without a map and without a proof");
  cli::add_output(
      app, "-o,--output", options.output,
      "file to write (default: stdout); with %s in the name, a file for each trajectory, %s "
      "being its id");
  cli::add_output(app, "--python", options.python,
                  "Tello: also write a program for the library DJITelloPy that flies it");
  cli::add_output(app, "--table", options.table,
                  "Tello: also write a table of where and when each leg ends, CSV");
  options.vehicle.add_to(app);
  options.vehicle.add_memory_to(app);
  options.vehicle.add_spare_to(app);
}

void refuse_idle(const CLI::App& app, const std::string& format, bool unchecked) {
  const bool tello = format == "tello";
  const bool mission = format == "wpl" || format == "qgc-plan" || format == "dji-wpml";
  const bool line = format == "kml" || format == "geojson";
  const bool legs = tello || mission || line || format == "gltf";
  cli::only_for(app, format == "setpoints", {"--rate", "--axes"}, "--format setpoints");
  cli::only_for(app, legs, {"--tolerance"}, "formats of straight legs");
  cli::only_for(app, tello || mission, {"--speed", "--hover", "--ground"},
                "missions and Tello scripts");
  // --origin and --geoid say where the map is: that is true whatever the format needs of it.
  cli::only_for(app, tello, {"--takeoff-height", "--heading", "--python", "--table"},
                "--format tello");
  cli::only_for(app, format == "dji-wpml", {"--wpml-version", "--aircraft", "--turns"},
                "--format dji-wpml");
  cli::only_for(app, !unchecked, {"--margin", "--spare"}, "an export that is checked");
}

// A Tello's go and DJI's missions have no other speeds, so one that is asked for is not changed in
// silence.
void require_flyable(const Task& task) {
  if (task.format == "tello" && task.speed.value_or(1) > 1) {
    throw cli::UsageError(fmt::format(
        "--speed: expected 0.1 to 1 m/s, as a Tello's go takes 10 to 100 cm/s, found {}",
        *task.speed));
  }
  if (task.format == "dji-wpml" && task.speed.value_or(1) > traj::kDjiFastest) {
    throw cli::UsageError(
        fmt::format("--speed: expected at most {} m/s, as DJI's missions take, "
                    "found {}",
                    traj::kDjiFastest, *task.speed));
  }
}

// Without a map nothing judges the speed of each leg, so that it must suit legs in any direction.
void require_slow_enough(const Task& task) {
  const std::optional<double> most = exporting::speed_limit(task.limits);
  if (!task.speed || !most || *task.speed <= *most) return;
  throw cli::UsageError(
      fmt::format("--speed: expected at most {} m/s, which {} may fly in every direction, found {}",
                  *most, task.id, *task.speed));
}

void set_way(const Flight& flight, geom::Axes axes, Task& task) {
  task.enu = traj::to_enu(axes, flight.trajectory);
  task.path = traj::to_enu(axes, flight.path);
}

Written write_unchecked(const Options& options, const Flight& flight, Task& task) {
  task.limits = flight.limits;
  const auto asked = options.vehicle.asked(options.vehicle.profile());
  if (asked.vehicle || flight.provenance.vehicle) {
    const auto room =
        cli::agreed_room(flight.provenance, asked, cli::Differences::refused, options.input(), 0);
    task.limits = geom::limits_that_hold({{}, flight.limits, room.vehicle.limits});
  }
  require_slow_enough(task);
  task.frame.axes = flight.provenance.frame.value_or(geom::Axes::enu);
  task.ground = task.landing = task.placement.ground.value_or(0);
  set_way(flight, task.frame.axes, task);
  return exporting::write(
      task, task.path.empty() ? traj::straight_legs(task.enu, task.tolerance) : task.path);
}

// What a file of straight legs does not command, and its check cannot hold.
void warn_of_unmeasured(const cli::Common& common, const Task& task,
                        const traj::CheckResult& result) {
  std::vector<std::string> missing;
  for (const traj::Limit limit : traj::not_measured(result, task.limits)) {
    missing.push_back(exporting::in_words(traj::kind_of(limit).quantity));
  }
  if (missing.empty()) return;
  common.warn(fmt::format("{}: a {} file sets no limit on {}: set it in the vehicle itself",
                          task.id, task.format, fmt::join(missing, ", ")));
}

// The exports of a run, one record at a time.
class Exporter {
 public:
  Exporter(const cli::Common& common, const Options& options, Task task)
      : common_(common), options_(options), task_(std::move(task)) {
    if (options.unchecked) return;
    scenes_.emplace(cli::open_map(options.files[0], geom::Verified::contents), options.vehicle,
                    cli::Scenes::Differences::refused);
  }

  // What a record gives.
  struct Export {
    Task task;
    std::optional<Written> written;  // nothing where it was refused, which stderr says
  };
  Export make(const Flight& flight) {
    Export made{task_, {}};
    made.task.id = flight.id;
    const std::string missing = flight.missing.empty() ? not_for(flight) : flight.missing;
    if (!missing.empty()) {
      cli::complain("skyway-export", fmt::format("{}: refused: {}", flight.id, missing));
      return made;
    }
    made.written = options_.unchecked ? write_unchecked(options_, flight, made.task)
                                      : write_checked(flight, made.task);
    if (!made.written) return made;
    if (made.task.format == "crazyflie") warn_of_memory(common_, made.task);
    warn_of_what_is_left_out(common_, made.task, flight);
    if (!made.written->note.empty()) common_.warn(flight.id + ": " + made.written->note);
    return made;
  }

 private:
  // Why the format cannot have it, or nothing.
  std::string not_for(const Flight& flight) const {
    if (flight.path.empty() || exporting::has_legs(task_.format)) return "";
    return fmt::format(
        "a {} file has times, and a path has none: make a trajectory of it "
        "(skyway-traj)",
        task_.format);
  }

  std::optional<Written> write_checked(const Flight& flight, Task& task) {
    const auto& scene = scenes_->scene_for(flight.provenance, options_.input(), 0);
    task.limits = geom::limits_that_hold({{}, flight.limits, scene.vehicle().limits});
    task.frame = scene.map().spec().frame;
    set_way(flight, task.frame.axes, task);
    set_ground(scene, flight, task);
    auto [written, result] = exporting::write_proved(scene, task);
    if (result.ok) {
      warn_of_unmeasured(common_, task, result);
      return std::move(written);
    }
    cli::complain("skyway-export", refusal(scene, task, result));
    return std::nullopt;
  }

  const cli::Common& common_;
  const Options& options_;
  const Task task_;  // but for what a record says
  std::optional<cli::Scenes> scenes_;
};

// The files of one record, or of all.
class Outputs {
 public:
  explicit Outputs(const Options& options)
      : names_{OutputNames(options.output, "--output"), OutputNames(options.python, "--python"),
               OutputNames(options.table, "--table")},
        source_(options.input() == "-" ? "stdin" : options.input()),
        wanted_{true, !options.python.empty(), !options.table.empty()} {}

  bool each() const { return names_[0].each(); }

  // Throws where two records would be one file.
  void add(const std::string& id) {
    Files files;
    for (int i = 0; i < 3; ++i) {
      if (wanted_[i]) files[i] = names_[i].of(id, source_);
    }
    files_.push_back(files);
  }

  // Files of an earlier run that would be taken for the record's, though it was refused.
  std::vector<std::string> stale(std::size_t index) const {
    std::vector<std::string> stale;
    for (const std::string& file : files_[index]) {
      if (!file.empty() && std::filesystem::exists(file)) stale.push_back(file);
    }
    return stale;
  }

  // Of the record that was added as the `index`-th. Of many, each appears as it is whole.
  void save(std::size_t index, const std::string& format, const Written& written) const {
    const bool binary = format == "gltf" || format == "dji-wpml";
    const auto kind = binary ? cli::OutputKind::artefact : cli::OutputKind::text;
    const std::string* const texts[] = {&written.text, &written.python, &written.csv};
    std::list<cli::OutputFile> outputs;
    for (int i = 0; i < 3; ++i) {
      if (wanted_[i]) outputs.emplace_back(files_[index][i], kind).stream() << *texts[i];
    }
    for (cli::OutputFile& file : outputs) each() ? file.commit_now() : file.commit();
  }

 private:
  using Files = std::array<std::string, 3>;
  std::array<OutputNames, 3> names_;
  std::string source_;
  std::array<bool, 3> wanted_;
  std::vector<Files> files_;
};

void warn_of_stale(const cli::Common& common, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    common.warn(file + " is of an earlier run, and not what was refused now: do not fly it");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a trajectory as a drone file, proved as it will be flown.", "skyway-export"};
  cli::Common common(app);
  Options options;
  Task task;
  add_options(app, options, task);
  return cli::run_tool(app, argc, argv, [&] {
    options.require_sound();
    refuse_idle(app, task.format, options.unchecked);
    require_flyable(task);
    Outputs outputs(options);
    const auto flights = exporting::read_flights(options.input(), options.id, outputs.each());
    for (const Flight& flight : flights) outputs.add(flight.id);
    task.ned = options.axes == "ned";
    task.lands = !options.hover;
    task.checked = !options.unchecked;
    Exporter exporter(common, options, task);
    std::size_t refused = 0;
    nlohmann::ordered_json stats;
    for (std::size_t i = 0; i < flights.size(); ++i) {
      const auto [made, written] = exporter.make(flights[i]);
      if (!written) {
        ++refused;
        if (outputs.each()) warn_of_stale(common, outputs.stale(i));
        continue;
      }
      outputs.save(i, made.format, *written);
      if (!outputs.each()) stats = statistics(made, *written);
    }
    if (outputs.each()) {
      stats = {{"format", task.format}, {"records", flights.size()}, {"refused", refused}};
      if (refused) {
        cli::complain("skyway-export",
                      fmt::format("{} of {} were refused: no file was written for them", refused,
                                  flights.size()));
      }
    }
    if (!stats.is_null()) common.write_stats(stats);
    return refused ? cli::Exit::no : cli::Exit::yes;
  });
}
