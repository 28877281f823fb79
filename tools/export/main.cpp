// skyway-export: drone files, read back and proved as the drone will fly them.

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <optional>
#include <utility>

#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "prove.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/straight_legs.h"
#include "traj/record/trajectory_record.h"
#include "writer.h"

namespace {

using exporting::Task;
using exporting::Written;
using traj::TrajectoryRecord;

// The one record of the stream. Two flights do not fit one drone file.
TrajectoryRecord read_one(const std::string& input) {
  cli::InputFile file(input);
  std::optional<TrajectoryRecord> record;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    if (record) {
      throw geom::InputError(file.name(), number,
                             "expected one trajectory, found another: choose one with --id");
    }
    record = traj::parse_trajectory_record(line, file.name(), number);
  });
  return *record;
}

TrajectoryRecord read_named(const std::string& input, const std::string& id) {
  cli::InputFile file(input);
  std::optional<TrajectoryRecord> found;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    TrajectoryRecord record = traj::parse_trajectory_record(line, file.name(), number);
    if (record.id != id) return;
    if (found) {
      throw geom::InputError(
          file.name(), number,
          fmt::format("expected one trajectory of id \"{}\", found another", id));
    }
    found = std::move(record);
  });
  if (!found)
    throw geom::InputError(file.name(),
                           fmt::format("expected a trajectory of id \"{}\", found none", id));
  return *found;
}

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

// Straight legs end in rests of their own, not in those of the trajectory.
void warn_of_holds(const cli::Common& common, const Task& task) {
  if (!exporting::has_legs(task.format)) return;
  double held = 0;
  for (const traj::Segment& s : task.enu.segments) {
    const auto here = [&](const geom::Vec3& p) { return p == s.point.front(); };
    if (std::all_of(s.point.begin(), s.point.end(), here)) held += s.duration;
  }
  if (held > 0) {
    common.warn(
        fmt::format("{}: it stands still for {:.4g} s in all; a {} file has no such pauses, "
                    "so they are left out",
                    task.id, held, task.format));
  }
}

void set_ground(const geom::CollisionScene& scene, const TrajectoryRecord& record, Task& task) {
  const auto& segments = record.trajectory.segments;
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
  }

  void save(const Task& task, const Written& written) const {
    const auto kind = task.format == "gltf" ? cli::OutputKind::artefact : cli::OutputKind::text;
    std::list<cli::OutputFile> outputs;
    outputs.emplace_back(output, kind).stream() << written.text;
    if (!python.empty()) outputs.emplace_back(python, kind).stream() << written.python;
    if (!table.empty()) outputs.emplace_back(table, kind).stream() << written.csv;
    for (cli::OutputFile& file : outputs) file.commit();
  }
};

void add_options(CLI::App& app, Options& options, Task& task) {
  app.add_option("map_and_file", options.files,
                 "box map, then trajectories (default: stdin); with "
                 "--unchecked trajectories alone")
      ->expected(0, 2);
  app.add_option("--format", task.format, "what to write")
      ->required()
      ->check(CLI::IsMember(
          {"tello", "crazyflie", "qgc-plan", "wpl", "setpoints", "kml", "geojson", "gltf"}));
  app.add_option("--rate", task.rate, "setpoints: how many a second, Hz (default 50)")
      ->check(CLI::Range(0.1, 10000.0));
  app.add_option("--axes", options.axes, "setpoints: axes, enu or ned (default enu)")
      ->check(CLI::IsMember({"enu", "ned"}));
  app.add_option("--tolerance", task.tolerance,
                 "how far straight legs may be from the curve, metres (default 0.2); while the "
                 "check refuses them, their points are moved off obstacles, and this is halved")
      ->check(CLI::Range(1e-3, 100.0));
  app.add_option("--speed", task.speed,
                 "m/s along straight legs (default: what the limits allow, and 1 for a Tello)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_flag("--hover", options.hover, "end a mission hovering, without landing");
  task.placement.add_to(app);
  app.add_option("--id", options.id, "which trajectory of the stream (default: its only one)");
  app.add_flag("--unchecked", options.unchecked, "write without a map and without a proof");
  cli::add_output(app, "-o,--output", options.output, "file to write (default: stdout)");
  cli::add_output(app, "--python", options.python,
                  "Tello: also write a program for the library DJITelloPy that flies it");
  cli::add_output(app, "--table", options.table,
                  "Tello: also write a table of where and when each leg ends, CSV");
  options.vehicle.add_to(app);
}

void refuse_idle(const CLI::App& app, const std::string& format, bool unchecked) {
  const bool tello = format == "tello";
  const bool mission = format == "wpl" || format == "qgc-plan";
  const bool line = format == "kml" || format == "geojson";
  const bool legs = tello || mission || line || format == "gltf";
  cli::only_for(app, format == "setpoints", {"--rate", "--axes"}, "--format setpoints");
  cli::only_for(app, legs, {"--tolerance"}, "formats of straight legs");
  cli::only_for(app, tello || mission, {"--speed", "--hover", "--ground"},
                "missions and Tello scripts");
  // --origin and --geoid say where the map is: that is true whatever the format needs of it.
  cli::only_for(app, tello, {"--takeoff-height", "--heading", "--python", "--table"},
                "--format tello");
  cli::only_for(app, !unchecked, {"--margin"}, "an export that is checked");
}

// Without a map nothing judges the speed of each leg, so that it must suit legs in any direction.
void require_slow_enough(const Task& task) {
  const std::optional<double> most = exporting::speed_limit(task.limits);
  if (!task.speed || !most || *task.speed <= *most) return;
  throw cli::UsageError(
      fmt::format("--speed: expected at most {} m/s, which {} may fly in every direction, found {}",
                  *most, task.id, *task.speed));
}

Written write_unchecked(const Options& options, const TrajectoryRecord& record, Task& task) {
  TrajectoryRecord made_for = record;
  const auto asked = options.vehicle.asked(options.vehicle.profile());
  if (asked.vehicle || record.provenance.vehicle) {
    made_for.provenance.vehicle =
        cli::agreed_room(record.provenance, asked, cli::Differences::refused, options.input(), 0)
            .vehicle;
  }
  task.limits = traj::limits_of(made_for);
  require_slow_enough(task);
  task.frame.axes = record.provenance.frame.value_or(geom::Axes::enu);
  task.ground = task.landing = task.placement.ground.value_or(0);
  task.enu = traj::to_enu(task.frame.axes, record.trajectory);
  return exporting::write(task, traj::straight_legs(task.enu, task.tolerance));
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

// Nothing where it is refused, which it says.
std::optional<Written> write_checked(const cli::Common& common, const Options& options,
                                     const TrajectoryRecord& record, Task& task) {
  cli::Scenes scenes(cli::open_map(options.files[0], geom::Verified::contents), options.vehicle,
                     cli::Scenes::Differences::refused);
  const auto& scene = scenes.scene_for(record.provenance, options.input(), 0);
  task.limits = geom::limits_that_hold({{}, record.limits, scene.vehicle().limits});
  task.frame = scene.map().spec().frame;
  task.enu = traj::to_enu(task.frame.axes, record.trajectory);
  set_ground(scene, record, task);
  auto [written, result] = exporting::write_proved(scene, task);
  if (result.ok) {
    warn_of_unmeasured(common, task, result);
    return std::move(written);
  }
  cli::complain("skyway-export", refusal(task, result));
  return std::nullopt;
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
    const std::string input = options.input();
    const TrajectoryRecord record =
        options.id.empty() ? read_one(input) : read_named(input, options.id);
    if (record.status != traj::TrajectoryStatus::solved) {
      cli::complain("skyway-export",
                    fmt::format("{}: refused: the record holds no trajectory (status {})",
                                record.id, name(record.status)));
      return cli::Exit::no;
    }
    task.id = record.id;
    task.ned = options.axes == "ned";
    task.lands = !options.hover;
    task.checked = !options.unchecked;
    const std::optional<Written> written = options.unchecked
                                               ? write_unchecked(options, record, task)
                                               : write_checked(common, options, record, task);
    if (!written) return cli::Exit::no;
    if (task.format == "crazyflie") warn_of_memory(common, task);
    warn_of_holds(common, task);
    options.save(task, *written);
    common.write_stats(statistics(task, *written));
    return cli::Exit::yes;
  });
}
