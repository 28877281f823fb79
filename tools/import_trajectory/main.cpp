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
    if (mission && mission->terrain) {
      common.warn(file.id +
                  ": the record is the middle of bands that skyway-check MAP FILE looks at whole");
    }
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

struct Options {
  cli::DroneFileOptions file{.format = cli::kAuto};
  cli::VehicleOptions vehicle;
  std::string input;
  std::string output = "-";
  std::string map;
  std::string axes;
  std::string id;
  double gap = 1e-3;
  geom::FlightTime time;
  cli::MetresOption metres;

  void add_to(CLI::App& app);
};

void Options::add_to(CLI::App& app) {
  file.app = &app;
  app.add_option("file", input, "Crazyflie CSV, WPL, QGroundControl plan, … ; - for stdin")
      ->required();
  app.add_option("--format", file.format,
                 "what the file is (default: found out from its beginning)")
      ->check(CLI::IsMember(cli::drone_file_words("skyway-import-trajectory")));
  CLI::Option* const map_option =
      app.add_option("--map", map, "box map that the file is for: gives the axes and the origin");
  app.add_option("--frame", axes, "axes to write in: enu or neu (default enu)")
      ->check(CLI::IsMember({"enu", "neu"}))
      ->excludes(map_option);
  vehicle.add_to(app);
  cli::add_placement(app, file.reading.placement);
  file.add_heights_to(app);
  file.autopilot.add_reading_to(app);
  cli::add_point(
      app, "--takeoff-place", file.reading.start,
      "where a Tello stands before it takes off, along the axes of --frame or of the map");
  metres.add_to(app);
  add_gap(app, gap);
  add_time(app, time);
  app.add_option("--id", id, "id of the record (default: the file's name)");
  cli::add_output(app, "-o,--output", output,
                  "trajectories or paths, JSON Lines (default: stdout)");
}

// The flights of the file; one has the id that was asked for.
std::vector<traj::FileFlight> read(cli::InputFile& file, const Options& options,
                                   const geom::Frame& frame) {
  auto flights = cli::read_drone_file(file.read_all(), file.name(), options.file, frame);
  options.file.require_used(flights, file.name());
  if (options.id.empty()) return flights;
  if (flights.size() > 1) throw cli::UsageError("--id names one record, found more");
  flights.front().id = options.id;
  return flights;
}

// Throws for what is no record, and for degrees where metres are expected.
void require_record(const traj::FileFlight& flight, const Options& options,
                    const geom::Frame& frame) {
  if (std::holds_alternative<traj::FlownSetpoints>(flight.flown.way)) {
    throw cli::UsageError("setpoints are no trajectory: skyway-check reads them");
  }
  if (flight.format->is_flown) return;
  options.metres.check_input(frame, traj::legs_of(flight.flown)->path, flight.id, 0);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Read a drone file as a trajectory or a path.", "skyway-import-trajectory"};
  cli::Common common(app);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({options.input, options.map, options.file.autopilot.params});
    if (const auto fault = geom::time_fault(options.time)) throw cli::UsageError(sentence(*fault));
    cli::InputFile file(options.input);
    Importer importer{common, file.name(), options.gap, {}, options.time};
    const geom::Frame frame = frame_of(options.map, options.axes, importer.provenance);
    const geom::AskedRoom room = options.vehicle.asked(options.vehicle.profile());
    importer.provenance.vehicle = room.vehicle;
    importer.provenance.margin = room.margin;
    options.file.autopilot.settle(options.vehicle.profile());
    options.file.settle_ground(frame);
    const auto flights = read(file, options, frame);
    cli::OutputFile out(options.output, cli::OutputKind::text);
    for (const traj::FileFlight& one : flights) {
      require_record(one, options, frame);
      out.stream() << importer.line(one);
    }
    out.commit();
    common.write_stats(
        {{"records", flights.size()}, {"format", flights.front().format->format.word}});
    return cli::Exit::yes;
  });
}
