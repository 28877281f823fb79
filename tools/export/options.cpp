#include "options.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/placement_option.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "dji_options.h"
#include "geom/text/output_names.h"
#include "traj/mission/airspace/flight_volumes.h"
#include "traj/record/tube_reports.h"

namespace exporting {
namespace {

void refuse_idle(const CLI::App& app, const std::string& word, bool unchecked) {
  const std::string as = word == "gpkg" ? "geojson" : word;
  cli::require_used(app, cli::file_option_rows(&traj::MissionFormat::writes_with), as,
                    "--format is " + word);
  cli::only_for(app, !unchecked, {"--margin", "--spare", "--metres", "--navigation", "--tracking"},
                "an export that is checked");
}

// A Tello's go and DJI's missions have no other speeds, so one that is asked for is not changed in
// silence.
void require_flyable(const traj::MissionFormat& format, const std::optional<double>& speed) {
  if (format.fastest == 0 || speed.value_or(0) <= format.fastest) return;
  throw cli::UsageError(
      fmt::format("--speed: expected {}, found {}", format.fastest_because, *speed));
}

std::vector<std::string> format_words() {
  const auto words = traj::written_mission_words();
  std::vector<std::string> out(words.begin(), words.end());
  out.emplace_back("gpkg");
  return out;
}

}  // namespace

void Options::add_to(CLI::App& app) {
  app.add_option("map_and_file", files,
                 "box map, then trajectories or paths (default: stdin); with --unchecked no map")
      ->expected(0, 2);
  app.add_option("--format", word, "what to write")
      ->required()
      ->check(CLI::IsMember(format_words()));
  app.add_option("--rate", file.rate, "setpoints: how many a second, Hz (default 50)")
      ->check(CLI::Range(0.1, 10000.0));
  app.add_option("--axes", axes, "setpoints: axes, enu or ned (default enu)")
      ->check(CLI::IsMember({"enu", "ned"}));
  app.add_option("--tolerance", file.tolerance,
                 "how far straight legs may be from the curve, metres (default 0.2); while the "
                 "check refuses them, their points are moved off obstacles, and this is halved; "
                 "how far the points of a path may be moved")
      ->check(CLI::Range(1e-3, 100.0));
  app.add_option("--speed", file.speed,
                 "m/s along straight legs (default: what the limits allow; a Tello's are flown at "
                 "0.1 to 1, its default is 1 where the limits allow it)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_flag("--hover", hover, "end a mission hovering, without landing");
  add_dji_options(app, file.dji, file.turns);
  app.add_option("--volumes", file.volumes,
                 "volume4d: how many volumes of airspace at most, one after the other (default 8)")
      ->check(CLI::Range(std::size_t{1}, traj::kMostVolumes));
  app.add_option("--buffer", file.buffer,
                 "volume4d: metres around the vehicle and its margin on every side, for how far it "
                 "may stray (default 0)")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option("--tube", tube,
                 "volume4d: reports of skyway-fly --proved-tube; the volumes hold the vehicle in "
                 "its proved tube, which takes the place of the margin");
  autopilot.add_to(app);
  autopilot.add_tracking_to(app);
  cli::add_placement(app, file.placement);
  metres.add_to(app);
  app.add_option("--id", id, "which record of the stream (default: its only one)");
  app.add_flag("--unchecked", unchecked, "write without a map and without a proof");
  cli::add_output(
      app, "-o,--output", output,
      "file (default: stdout); with %s in the name, a file for each trajectory, %s being its id");
  app.add_option(
         "--show", show,
         "Crazyflie: a folder to make, with a file for each trajectory and show.yaml, which "
         "says when each begins; all pairs are proved apart")
      ->type_name("FOLDER")
      ->excludes("--output", "--id");
  cli::add_output(app, "--python", python,
                  "Tello: also write a program for the library DJITelloPy that flies it");
  cli::add_output(app, "--table", table,
                  "Tello: also write a table of where and when each leg ends, CSV");
  returns.add_to(app);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  vehicle.add_spare_to(app);
  cli::add_spacing(app, spacing, parked);
}

void Options::require_sound(const CLI::App& app) const {
  if (unchecked && !format().write) {
    throw cli::UsageError(
        "volumes of airspace are proved to hold the flight or not written at all: leave "
        "--unchecked out");
  }
  if (files.empty() && !unchecked) throw cli::UsageError("map is required (or --unchecked)");
  if (files.size() > map_files() + 1) throw cli::UsageError("--unchecked takes no map");
  if (!unchecked) cli::at_most_one_stdin({files[0], input(), tube});
  require_outputs();
  refuse_idle(app, word, unchecked);
  returns.require_sound(app, word, unchecked);
  cli::only_for(app, !format().write, {"--tube"}, "--format volume4d");
  cli::only_for(app, !show.empty() && !unchecked, cli::kSpacingOptions, "a --show that is checked");
  require_flyable(format(), file.speed);
}

void Options::settle() {
  if (!tube.empty()) {
    cli::InputFile reports(tube);
    file.tubes = std::make_shared<const traj::TubeReports>(
        traj::TubeReports::read(reports.stream(), reports.name()));
  }
  autopilot.settle(vehicle.profile());
  file.flier = autopilot.flier;
  file.ned = axes == "ned";
  file.lands = !hover;
  file.says_when = !show.empty();
}

std::array<Options::Output, 7> Options::outputs() const {
  return {{{output, "--output"},
           {python, "--python"},
           {table, "--table"},
           {returns.fences_out, "--fence-out"},
           {returns.rally_out, "--rally-out"},
           {returns.params_out, "--params-out"},
           {returns.procedure, "--procedure"}}};
}

void Options::require_outputs() const {
  const auto all = outputs();
  if (std::ranges::count(all, std::string("-"), &Output::name) > 1) {
    throw cli::UsageError("the drone file and the files beside it cannot share stdout");
  }
  const bool each = geom::OutputNames(output, "--output").each();
  if (each && is_geopackage()) {
    throw cli::UsageError("--output: a GeoPackage holds all flights: leave %s out");
  }
  for (const Output& one : all) {
    if (!one.name.empty() && geom::OutputNames(one.name, one.option).each() != each) {
      throw cli::UsageError(
          fmt::format("--output and {}: expected %s in both or in neither, found \"{}\" and \"{}\"",
                      one.option, output, one.name));
    }
  }
}

}  // namespace exporting
