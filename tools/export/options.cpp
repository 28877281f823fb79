#include "options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cli/file/files.h"
#include "cli/option/format_options.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "dji_options.h"
#include "output_names.h"
#include "traj/airspace/flight_volumes.h"

namespace exporting {
namespace {

using cli::FormatOption;

const std::array kFormatOptions{
    FormatOption{"--rate", {"setpoints"}},
    FormatOption{"--axes", {"setpoints"}},
    FormatOption{"--tolerance", {"tello", "wpl", "qgc-plan", "dji-wpml", "kml", "geojson", "gltf"}},
    FormatOption{"--speed", {"tello", "wpl", "qgc-plan", "dji-wpml"}},
    FormatOption{"--hover", {"tello", "wpl", "qgc-plan", "dji-wpml"}},
    FormatOption{"--ground", {"tello", "wpl", "qgc-plan", "dji-wpml"}},
    FormatOption{"--origin", {"wpl", "qgc-plan", "dji-wpml", "kml", "geojson", "volume4d"}},
    FormatOption{"--geoid", {"wpl", "qgc-plan", "kml"}},
    FormatOption{"--takeoff-height", {"tello"}},
    FormatOption{"--heading", {"tello"}},
    FormatOption{"--python", {"tello"}},
    FormatOption{"--table", {"tello"}},
    FormatOption{"--wpml-version", {"dji-wpml"}},
    FormatOption{"--aircraft", {"dji-wpml"}},
    FormatOption{"--turns", {"dji-wpml"}},
    FormatOption{"--show", {"crazyflie"}},
    FormatOption{"--autopilot", {"wpl", "qgc-plan"}},
    FormatOption{"--params", {"wpl", "qgc-plan"}},
    FormatOption{"--drag", {"wpl", "qgc-plan"}},
    FormatOption{"--navigation",
                 {"tello", "crazyflie", "wpl", "qgc-plan", "dji-wpml", "setpoints", "kml",
                  "geojson", "gltf"}},
    FormatOption{"--tracking",
                 {"tello", "crazyflie", "dji-wpml", "setpoints", "kml", "geojson", "gltf"}},
    FormatOption{"--volumes", {"volume4d"}},
    FormatOption{"--buffer", {"volume4d"}}};

void refuse_idle(const CLI::App& app, const std::string& format, bool unchecked) {
  cli::require_used(app, kFormatOptions, format, "--format is " + format);
  cli::only_for(app, !unchecked, {"--margin", "--spare", "--metres", "--navigation", "--tracking"},
                "an export that is checked");
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

}  // namespace

void Options::add_to(CLI::App& app, Task& task) {
  app.add_option("map_and_file", files,
                 "box map, then trajectories or paths (default: stdin); with "
                 "--unchecked no map")
      ->expected(0, 2);
  app.add_option("--format", task.format, "what to write")
      ->required()
      ->check(CLI::IsMember({"tello", "crazyflie", "qgc-plan", "wpl", "dji-wpml", "setpoints",
                             "kml", "geojson", "gltf", "volume4d"}));
  app.add_option("--rate", task.rate, "setpoints: how many a second, Hz (default 50)")
      ->check(CLI::Range(0.1, 10000.0));
  app.add_option("--axes", axes, "setpoints: axes, enu or ned (default enu)")
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
  app.add_flag("--hover", hover, "end a mission hovering, without landing");
  add_dji_options(app, task.dji, task.turns);
  app.add_option("--volumes", task.volumes,
                 "volume4d: how many volumes of airspace at most, one after the other (default 8)")
      ->check(CLI::Range(std::size_t{1}, traj::kMostVolumes));
  app.add_option("--buffer", task.buffer,
                 "volume4d: metres around the vehicle and its margin on every side, for how far it "
                 "may stray (default 0)")
      ->check(CLI::Range(0.0, 1000.0));
  task.autopilot.add_to(app);
  task.autopilot.add_tracking_to(app);
  task.placement.add_to(app);
  metres.add_to(app);
  app.add_option("--id", id, "which record of the stream (default: its only one)");
  app.add_flag("--unchecked", unchecked, "write without a map and without a proof");
  cli::add_output(
      app, "-o,--output", output,
      "file to write (default: stdout); with %s in the name, a file for each trajectory, %s "
      "being its id");
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
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  vehicle.add_spare_to(app);
  cli::add_spacing(app, spacing, parked);
}

void Options::require_sound(const CLI::App& app, const Task& task) const {
  if (unchecked && task.format == "volume4d") {
    throw cli::UsageError(
        "volumes of airspace are proved to hold the flight or not written at all: leave "
        "--unchecked out");
  }
  if (files.empty() && !unchecked) throw cli::UsageError("map is required (or --unchecked)");
  if (files.size() > map_files() + 1) throw cli::UsageError("--unchecked takes no map");
  if (!unchecked) cli::at_most_one_stdin({files[0], input()});
  require_outputs();
  refuse_idle(app, task.format, unchecked);
  cli::only_for(app, !show.empty() && !unchecked, cli::kSpacingOptions, "a --show that is checked");
  require_flyable(task);
}

void Options::require_outputs() const {
  const std::string outputs[] = {output, python, table};
  if (std::count(std::begin(outputs), std::end(outputs), "-") > 1) {
    throw cli::UsageError("the script, --python and --table cannot share stdout");
  }
  const bool each = OutputNames(output, "--output").each();
  for (const auto& [name, option] : {std::pair(python, "--python"), std::pair(table, "--table")}) {
    if (!name.empty() && OutputNames(name, option).each() != each) {
      throw cli::UsageError(
          fmt::format("--output and {}: expected %s in both or in neither, found \"{}\" and "
                      "\"{}\"",
                      option, output, name));
    }
  }
}

}  // namespace exporting
