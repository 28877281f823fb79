// skyway-view: everything in one HTML page that opens in any browser, without a server or network.

#include <fmt/format.h>

#include "cli/content/contents.h"
#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/placement_option.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/text/counted.h"
#include "layers.h"
#include "page.h"

namespace {

cli::Contents read(const std::vector<std::string>& files, cli::DroneFileOptions& options,
                   const cli::MetresOption& metres) {
  const cli::ContentKinds kinds{
      .archives = true,
      .corridors = true,
      .reports = true,
      .contingencies = true,
      .drone_files = &options,
      .expected = "a path, a trajectory, a tree, a corridor, a report or a way home"};
  cli::Contents contents = cli::read_contents(files, kinds);
  cli::require_same_map(contents, contents.map ? &contents.map->record : nullptr, metres);
  return contents;
}

constexpr std::size_t kLargeFrames = 3000000;  // bytes

void warn_if_large(const cli::Common& common, const view::Frames& frames) {
  const std::size_t bytes = frames.bytes();
  if (bytes <= kLargeFrames) return;
  common.warn(
      fmt::format("{} of {} x {} pixels make the page {:.1f} MB larger: a camera of "
                  "320 x 240 at --rate 2 keeps it small",
                  geom::counted(frames.list.size(), "frame"), frames.width, frames.height,
                  4e-6 / 3 * static_cast<double>(bytes)));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Show maps, lattices, search trees, paths, trajectories, flights and reports in one "
      "HTML page.",
      "skyway-view"};
  cli::Common common(app);
  cli::VehicleOptions vehicle;
  std::vector<std::string> files;
  std::string title = "Skyway";
  std::string output = "-";
  view::FrameFiles pictures;
  cli::DroneFileOptions drone_files{.format = cli::kAuto};
  cli::MetresOption metres;
  app.add_option(
         "files", files,
         "box map, lattices, records (JSON Lines), flight logs (CSV) and drone files (missions, "
         "KML, …); - for stdin")
      ->required();
  cli::add_output(app, "-o,--output", output, "HTML page to write (default: stdout)");
  app.add_option("--title", title, "title of the page");
  CLI::Option* frames_option =
      app.add_option("--frames", pictures.names,
                     "frames of skyway-render to show beside the plots, as f-%05d.png");
  CLI::Option* poses_option =
      app.add_option("--poses", pictures.poses, "what skyway-render --poses wrote with them");
  frames_option->needs(poses_option);
  poses_option->needs(frames_option);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  cli::add_point(app, "--takeoff-place", drone_files.reading.start,
                 "where a Tello stands before it takes off, along the map's axes");
  cli::add_placement(app, drone_files.reading.placement);
  drone_files.add_mission_to(app);
  drone_files.autopilot.add_reading_to(app);
  metres.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    std::vector<std::string> inputs = files;
    inputs.push_back(pictures.poses);
    cli::at_most_one_stdin(drone_files.autopilot.params, inputs);
    drone_files.terrain.refuse_idle(drone_files.reading.rules);
    drone_files.autopilot.settle(vehicle.profile());
    const cli::Contents contents = read(files, drone_files, metres);
    if (contents.map) cli::warn_of_unsaid_maps(common, contents);
    drone_files.require_any_used(app, contents.drone_flights);
    const bool moves = !contents.trajectories.empty() || !contents.flights.empty();
    const char* needs = "trajectories and flight logs over a map";
    cli::only_for(app, moves && contents.map, {"--margin"}, needs);
    cli::only_for(app, moves || !contents.drone_flights.empty(), {"--vehicle"},
                  "trajectories, flight logs and drone files");
    std::optional<view::Frames> frames;
    if (!pictures.names.empty()) frames = view::read_frames(pictures);
    view::Bundle bundle;
    const view::Json meta =
        view::describe(contents, frames, vehicle, common.execution("pairs"), bundle);
    const std::string page = view::page(title, meta, bundle);
    cli::OutputFile out(output, cli::OutputKind::artefact);
    out.stream() << page;
    out.commit();
    if (frames) warn_if_large(common, *frames);
    common.write_stats({{"boxes", contents.map ? contents.map->record.size() : 0},
                        {"trees", contents.trees.size()},
                        {"paths", contents.paths.size()},
                        {"motions", meta["motions"].size()},
                        {"reports", contents.reports.size()},
                        {"contingencies", contents.contingencies.size()},
                        {"frames", frames ? frames->list.size() : 0},
                        {"bytes", page.size()}});
    return cli::Exit::yes;
  });
}
