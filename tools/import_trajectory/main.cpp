// skyway-import-trajectory: other people's missions as trajectories and paths.

#include <fmt/format.h>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/placement_option.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "traj/mission/file_records.h"
#include "traj/solve/close_joints.h"

namespace {

struct Importer {
  const cli::Common& common;
  std::string source;
  double gap;  // m
  geom::Provenance provenance;
  geom::FlightTime time;

  std::string trajectory_line(const traj::FileFlight& file) const {
    const traj::ClosedJoints closed =
        traj::close_joints(traj::trajectory_of(file.flown), gap, source);
    if (closed.largest_gap > 0) {
      common.warn(fmt::format("{}: closed gaps of up to {:.2g} m between segments", file.id,
                              closed.largest_gap));
    }
    traj::TrajectoryRecord record = traj::trajectory_record(file, provenance);
    record.trajectory = closed.trajectory;
    record.time = time;
    return to_json_line(record);
  }

  std::string path_line(const traj::FileFlight& file, const traj::FlownLegs& legs) const {
    if (legs.speed) {
      common.warn(fmt::format(
          "{}: the file's speed, {} m/s, is left out: a path has none; give skyway-traj --vmax",
          file.id, *legs.speed));
    }
    geom::PathRecord record = *traj::path_record(file, provenance);
    record.time = time;
    return to_json_line(record);
  }

  std::string line(const traj::FileFlight& file) const {
    for (const std::string& note : file.notes) common.warn(file.id + ": " + note);
    const traj::FlownMission* mission = traj::mission_of(file.flown);
    if (mission && (!mission->sweeps.empty() || !mission->fences.empty() || mission->corners > 0)) {
      common.warn(file.id +
                  ": the record has the mission's straight legs, not its corners, curves and "
                  "fences: skyway-check --file-format looks at those");
    }
    const traj::FlownLegs* legs = traj::legs_of(file.flown);
    return legs ? path_line(file, *legs) : trajectory_line(file);
  }
};

// The frame that the options name, or the map's.
geom::Frame frame_of(const std::string& map, const std::string& axes,
                     geom::Provenance& provenance) {
  geom::Frame frame;
  if (!map.empty()) {
    const geom::BoxMap opened = cli::open_map(map, geom::Verified::contents);
    frame = opened.spec().frame;
    provenance.map = opened.hash();
  } else if (!axes.empty()) {
    frame.axes = *geom::value_of(geom::kAxesWords, axes);
  }
  provenance.frame = frame.axes;
  return frame;
}

// When the flight begins, which no drone file says.
void add_time(CLI::App& app, geom::FlightTime& time) {
  app.add_option("--departure", time.start, "when the flight begins: seconds after the epoch")
      ->check(CLI::Range(-geom::kLargestTime, geom::kLargestTime));
  app.add_option_function<std::string>(
         "--epoch",
         [&time](const std::string& text) {
           time.epoch = geom::epoch_from(text);
           if (time.epoch) return;
           throw cli::UsageError(
               "--epoch: expected an instant in UTC such as 2026-05-04T06:30:00Z, found \"" + text +
               '"');
         },
         "the instant that --departure counts from, UTC")
      ->type_name("INSTANT");
}

void add_gap(CLI::App& app, double& gap) {
  app.add_option(
         "--gap", gap,
         "metres by which segments of a trajectory may miss each other (default 0.001); ten "
         "times as many m/s and a hundred times as many m/s2")
      ->check(CLI::Range(0.0, 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Read a drone file as a trajectory or a path.", "skyway-import-trajectory"};
  cli::Common common(app);
  cli::DroneFileOptions options{.format = cli::kAuto};
  options.app = &app;
  cli::VehicleOptions vehicle;
  std::string input;
  std::string output = "-";
  std::string map;
  std::string axes;
  std::string id;
  double gap = 1e-3;
  geom::FlightTime time;
  cli::MetresOption metres;
  app.add_option("file", input, "Crazyflie CSV, WPL, QGroundControl plan, … ; - for stdin")
      ->required();
  app.add_option("--format", options.format,
                 "what the file is (default: found out from its beginning)")
      ->check(CLI::IsMember(cli::drone_file_words("skyway-import-trajectory")));
  CLI::Option* const map_option =
      app.add_option("--map", map, "box map that the file is for: gives the axes and the origin");
  app.add_option("--frame", axes, "axes to write in: enu or neu (default enu)")
      ->check(CLI::IsMember({"enu", "neu"}))
      ->excludes(map_option);
  vehicle.add_to(app);
  cli::add_placement(app, options.reading.placement);
  options.add_heights_to(app);
  cli::add_point(
      app, "--takeoff-place", options.reading.start,
      "where a Tello stands before it takes off, along the axes of --frame or of the map");
  metres.add_to(app);
  add_gap(app, gap);
  add_time(app, time);
  app.add_option("--id", id, "id of the record (default: the file's name)");
  cli::add_output(app, "-o,--output", output,
                  "trajectories or paths, JSON Lines (default: stdout)");
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({input, map});
    if (const auto fault = geom::time_fault(time)) throw cli::UsageError(sentence(*fault));
    cli::InputFile file(input);
    Importer importer{common, file.name(), gap, {}, time};
    const geom::Frame frame = frame_of(map, axes, importer.provenance);
    const geom::AskedRoom room = vehicle.asked(vehicle.profile());
    importer.provenance.vehicle = room.vehicle;
    importer.provenance.margin = room.margin;
    auto read = cli::read_drone_file(file.read_all(), file.name(), options, frame);
    if (!id.empty() && read.size() > 1) throw cli::UsageError("--id names one record, found more");
    if (!id.empty()) read.front().id = id;
    cli::OutputFile out(output, cli::OutputKind::text);
    for (const traj::FileFlight& one : read) {
      if (std::holds_alternative<traj::FlownSetpoints>(one.flown.way)) {
        throw cli::UsageError("setpoints are no trajectory: skyway-check reads them");
      }
      if (!one.format->is_flown) {
        metres.check_input(frame, traj::legs_of(one.flown)->path, one.id, 0);
      }
      out.stream() << importer.line(one);
    }
    out.commit();
    common.write_stats({{"records", read.size()}, {"format", read.front().format->format.word}});
    return cli::Exit::yes;
  });
}
