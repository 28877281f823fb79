// skyway-import-flight: what a vehicle flew, as a flight log.

#include <fmt/format.h>

#include <filesystem>

#include "cli/file/files.h"
#include "cli/option/geoid_option.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/placement_option.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "traj/mission/ulog/flight_notes.h"

namespace {

struct Options {
  std::string input;
  std::string output = "-";
  std::string map;
  std::string id;
  std::string begin = "first";
  traj::Placement placement;

  void add_to(CLI::App& app) {
    app.add_option("file", input, "PX4 log (.ulg); - for stdin")->required();
    CLI::Option* const map_option =
        app.add_option("--map", map, "box map that the flight is for: gives the origin");
    cli::add_origin(app, placement);
    cli::add_geoid_grid(app, placement);
    cli::add_ground(app, placement);
    app.get_option("--origin")->excludes(map_option);
    app.add_option("--begin", begin,
                   "where the time counts from, rows before being left out: first (position), "
                   "takeoff, or seconds after the first")
        ->type_name("first|takeoff|SECONDS");
    app.add_option("--id", id, "id of the flight (default: the file's name)");
    cli::add_output(app, "-o,--output", output, "flight log, CSV (default: stdout)");
  }
};

// Where the log's coordinates shall count from, and the map's hash.
struct Target {
  traj::Px4Options options;
  std::string map;
};

Target target_of(const Options& options) {
  Target out;
  geom::Frame frame;
  if (!options.map.empty()) {
    const geom::BoxMap map = cli::open_map(options.map, geom::Verified::contents);
    frame = map.spec().frame;
    out.map = map.hash();
  }
  if (!options.map.empty() || options.placement.origin) {
    out.options.over = options.placement.mission_frame(frame);
  } else if (options.placement.geoid != 0 || options.placement.geoid_grid ||
             options.placement.ground) {
    throw cli::UsageError(
        fmt::format("--{} needs --map or --origin", options.placement.ground       ? "ground"
                                                    : options.placement.geoid_grid ? "geoid-grid"
                                                                                   : "geoid"));
  }
  if (out.options.over && !out.options.over->height_known && !options.placement.ground) {
    throw cli::UsageError(
        "the log's heights are above the sea, and the map does not say how high its z = 0 is: give "
        "the map's z of the ground at the take-off (--ground)");
  }
  return out;
}

// Where --ground says how high the take-off is.
void set_ground(const Options& options, const cli::Common& common, const std::string& source,
                traj::Px4Flight& flight) {
  const auto& ground = options.placement.ground;
  if (!ground) return;
  const double was = traj::take_off_from(*ground, flight, source);
  common.warn(fmt::format(
      "the flight takes off from z = {:g}, as --ground says, and its other heights count from "
      "there: its z would be {:+.2f} m by its height above the sea",
      *ground, was));
}

// Seconds after the first position.
double begin_of(const Options& options, const traj::Px4Flight& flight, const std::string& source) {
  if (options.begin == "first") return 0;
  if (options.begin == "takeoff") {
    if (flight.takeoff) return *flight.takeoff;
    throw geom::InputError(source,
                           {.expected = "a take-off after the first position", .found = "none"});
  }
  const auto seconds = cli::parse_numbers(options.begin, 1);
  if (!seconds || seconds->front() < 0) {
    throw cli::UsageError("--begin: expected first, takeoff or seconds >= 0, found \"" +
                          options.begin + '"');
  }
  return seconds->front();
}

std::string words_of(const std::string& begin) {
  if (begin == "first") return "the first position";
  return begin == "takeoff" ? "take-off" : begin + " s after the first position";
}

std::string_view words_of(const Options& options) {
  if (!options.map.empty()) return "the map's origin";
  return options.placement.origin ? "the origin of --origin" : "";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Read a PX4 log as a flight log.", "skyway-import-flight"};
  cli::Common common(app);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({options.input, options.map});
    const Target target = target_of(options);
    const bool placed = target.options.over.has_value();
    cli::InputFile file(options.input);
    traj::Px4Flight flight = traj::read_px4_flight(file.stream(), file.name(), target.options);
    const bool constant = placed && !options.placement.geoid_grid;
    const auto geoid = constant ? std::optional(options.placement.geoid) : std::nullopt;
    for (const std::string& text : traj::warnings(flight, geoid)) common.warn(text);
    traj::require_positions(flight, file.name(), placed);
    set_ground(options, common, file.name(), flight);
    if (traj::begin_at(begin_of(options, flight, file.name()), flight)) {
      common.warn("--begin leaves out what the vehicle may have flown: the last row says cut");
    }
    if (flight.log.samples.empty()) {
      throw geom::InputError(file.name(),
                             {.expected = "a position after --begin", .found = "none"});
    }
    flight.log.id =
        options.id.empty() ? std::filesystem::path(file.name()).stem().string() : options.id;
    flight.log.map = target.map;
    cli::OutputFile out(options.output, cli::OutputKind::text);
    traj::write_flight_log(out.stream(), {&flight.log, 1});
    out.commit();
    cli::tell(common, "skyway-import-flight",
              traj::told(flight, words_of(options), words_of(options.begin)));
    common.write_stats(traj::stats(flight));
    return cli::Exit::yes;
  });
}
