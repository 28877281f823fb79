// skyway-export: drone files, read back and proved as the drone will fly them.

#include <fmt/format.h>

#include <sstream>

#include "cli/files.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/error.h"
#include "traj/check.h"
#include "traj/export/crazyflie.h"
#include "traj/export/setpoints.h"
#include "traj/io/trajectory_record.h"

namespace {

using traj::TrajectoryRecord;

struct Format {
  std::string name;
  double rate = 50;

  std::string write(const TrajectoryRecord& record, geom::Axes axes) const {
    std::ostringstream out;
    if (name == "crazyflie") {
      traj::write_crazyflie(out, record.trajectory, axes);
    } else {
      traj::write_setpoints(out, record.trajectory, axes, rate);
    }
    return out.str();
  }

  traj::CheckResult prove(const geom::CollisionScene& scene, const std::string& text,
                          const TrajectoryRecord& record) const {
    std::istringstream in(text);
    const geom::Axes axes = scene.map().spec().frame.axes;
    traj::CheckOptions options;
    if (name == "setpoints") {  // positions only: the client's own limits hold between them
      return traj::check(scene, traj::read_setpoints(in, "setpoints", axes), options);
    }
    // Single precision, as in the drone: joints meet to a millimetre, limits hold to 0.1%.
    options.limits = record.limits;
    options.position_gap = 1e-3;
    options.velocity_gap = 1e-2;
    options.acceleration_gap = 1e-1;
    options.limit_slack = 1e-3;
    return traj::check(scene, traj::read_crazyflie(in, "crazyflie", axes), options);
  }
};

std::string refusal(const TrajectoryRecord& record, const traj::CheckResult& result) {
  return fmt::format(
      "{}: refused: as flown, {} at t = {:.3f} s, ({:.3f}, {:.3f}, {:.3f}) m, {:.3g}", record.id,
      result.reason, result.time, result.place[0], result.place[1], result.place[2], result.worst);
}

// The one record of the stream. Two flights do not fit one drone file.
TrajectoryRecord read_one(const std::string& input) {
  cli::InputFile file(input);
  std::optional<TrajectoryRecord> record;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    if (record) {
      throw geom::InputError(file.name(), number,
                             "expected one trajectory a file, found another (use --id)");
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
    if (!found && record.id == id) found = std::move(record);
  });
  if (!found)
    throw geom::InputError(file.name(),
                           fmt::format("expected a trajectory of id \"{}\", found none", id));
  return *found;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Write a trajectory as a drone file, proved as it will be flown.", "skyway-export"};
  cli::Common common(app);
  cli::VehicleOptions vehicle;
  Format format;
  std::vector<std::string> files;
  std::string output = "-";
  std::string id;
  bool unchecked = false;
  app.add_option("map_and_file", files,
                 "box map, then trajectories (default: stdin); with "
                 "--unchecked trajectories alone")
      ->expected(0, 2);
  app.add_option("--format", format.name, "crazyflie or setpoints")
      ->required()
      ->check(CLI::IsMember({"crazyflie", "setpoints"}));
  app.add_option("--rate", format.rate, "setpoints a second, Hz (default 50)")
      ->check(CLI::Range(0.1, 10000.0));
  app.add_option("--id", id, "which trajectory of the stream (default: its only one)");
  app.add_flag("--unchecked", unchecked, "write without a map and without a proof");
  app.add_option("-o,--output", output, "file to write (default: stdout)");
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    if (files.empty() && !unchecked) throw cli::UsageError("map is required (or --unchecked)");
    const std::size_t input_at = unchecked ? 0 : 1;
    if (files.size() > input_at + 1) throw cli::UsageError("--unchecked takes no map");
    const std::string input = files.size() > input_at ? files[input_at] : "-";
    if (!unchecked) cli::at_most_one_stdin({files[0], input});
    const TrajectoryRecord record = id.empty() ? read_one(input) : read_named(input, id);
    if (record.status != "solved") {
      fmt::print(stderr, "skyway-export: {}: refused: {}\n", record.id, record.status);
      return cli::Exit::no;
    }
    std::string text;
    if (unchecked) {
      text = format.write(record, record.provenance.frame.value_or(geom::Axes::enu));
    } else {
      cli::Scenes scenes(cli::open_map(files[0]), vehicle, cli::Scenes::Differences::refused);
      const auto& scene = scenes.scene_for(record.provenance, input, 0);
      text = format.write(record, scene.map().spec().frame.axes);
      const traj::CheckResult result = format.prove(scene, text, record);
      if (!result.ok) {
        fmt::print(stderr, "skyway-export: {}\n", refusal(record, result));
        return cli::Exit::no;
      }
    }
    if (format.name == "crazyflie" &&
        record.trajectory.segments.size() > traj::kCrazyflieSegments) {
      common.warn(fmt::format("{}: {} segments; a Crazyflie's memory holds {}", record.id,
                              record.trajectory.segments.size(), traj::kCrazyflieSegments));
    }
    cli::OutputFile out(output, cli::OutputKind::text);
    out.stream() << text;
    out.commit();
    return cli::Exit::yes;
  });
}
