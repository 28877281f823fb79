// skyway-submit: a folder for an authority, with flights, volumes and proofs.

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "flight_files.h"
#include "geom/text/counted.h"
#include "geom/zone/zone_boxes.h"
#include "ground.h"
#include "options.h"
#include "people.h"
#include "submission_folder.h"
#include "traj/submit/summary_page.h"
#include "traj/submit/verify_scripts.h"
#include "tubes.h"
#include "view_page.h"

namespace {

using submitting::FlightFiles;
using submitting::Options;
using submitting::SubmissionFolder;

constexpr std::size_t kMostShown = 1000;  // flights, on a page that a browser opens in time
constexpr const char* kMadeBy = "skyway " SKYWAY_VERSION;

std::string text_of(const std::string& path) { return cli::InputFile(path).read_all(); }

void write_claims(const std::vector<traj::FlightClaims>& claims, SubmissionFolder& folder) {
  std::string lines;
  for (const traj::FlightClaims& one : claims) lines += traj::to_json_line(one);
  folder.add("claims.jsonl", lines);
}

std::vector<std::string> shown_files(const FlightFiles& flights, const SubmissionFolder& folder) {
  std::vector<std::string> files{folder.place_of("map.boxmap")};
  if (flights.has_records()) files.push_back(folder.place_of("flights.jsonl"));
  for (const std::string& mission : flights.missions()) {
    files.push_back(folder.place_of("missions/" + mission));
  }
  return files;
}

// The files on which the reading of missions rests, added to the folder.
traj::MethodFiles method_files(const Options& options, const geom::BoxMapSpec& spec,
                               const traj::SubmissionMethod& method, SubmissionFolder& folder) {
  traj::MethodFiles out;
  if (method.params) {
    out.params = text_of(options.params());
    folder.add(traj::kParamsFile, *out.params);
  }
  if (method.geoid_grid) {
    geom::BoxMapSpec placed = spec;
    placed.frame.origin = method.origin;
    const geom::SunArea area = geom::area_of(placed);
    out.geoid_grid =
        geom::gtx_over(*options.geoid_grid(), {area.south, area.north, area.west, area.east});
    folder.add(traj::kGeoidFile, *out.geoid_grid);
  }
  return out;
}

// The ground of the folder; unless the user says the floor, no ground over the map is below it.
std::optional<geom::GroundModel> ground_of(const Options& options, const geom::BoxMap& map,
                                           traj::SubmissionMethod& method,
                                           SubmissionFolder& folder) {
  auto ground = submitting::take_ground(options.terrain, map, method, folder);
  if (ground && !options.says_floor()) {
    method.floor = submitting::floor_over(*ground, map.spec().bounds);
  }
  return ground;
}

// Throws cli::UsageError for an option that no flight uses.
void require_used(const CLI::App& app, const traj::SubmissionMethod& method,
                  const FlightFiles& flights) {
  const traj::TerrainUse& use = flights.terrain_use();
  const bool missions = !flights.missions().empty();
  const bool returns = method.risk.contingency == traj::ContingencyRule::ways_home;
  cli::only_for(app, use.error, {"--terrain-error"}, "missions with heights above terrain");
  cli::only_for(app, use.surface, {"--surface-band"}, "missions of DJI that follow the surface");
  cli::only_for(app, missions, {"--between", "--geoid", "--geoid-grid", "--ground"}, "missions");
  cli::only_for(app, missions || returns, {"--autopilot", "--params", "--drag", "--navigation"},
                "missions, and for --contingency return");
  cli::only_for(app, flights.ends_at_home() || returns, {"--return-height"},
                "missions that end with a return, and for --contingency return");
}

// Missions have no times of their own, so trajectories alone are compared.
std::optional<traj::FlightPairs> compared(const cli::Common& common, FlightFiles& flights,
                                          const traj::SubmissionMethod& method) {
  if (!method.together) return std::nullopt;
  if (!flights.has_records()) {
    throw cli::UsageError("--together compares trajectories, and there is none: leave it out");
  }
  if (!flights.missions().empty()) {
    common.warn(
        fmt::format("--together: {} not compared, because missions have no times of their own",
                    geom::counted(flights.missions().size(), "mission is", "missions are")));
  }
  return flights.compare();
}

// Of few enough flights for a browser.
void add_page(const cli::Common& common, const FlightFiles& flights,
              const traj::SubmittedFlights& open, const std::string& by, SubmissionFolder& folder) {
  if (flights.count() > kMostShown) {
    common.warn(fmt::format("{} are too many for a page, so there is none (at most {})",
                            geom::counted(flights.count(), "flight"), kMostShown));
    return;
  }
  folder.add("page.html",
             submitting::view_page(common, shown_files(flights, folder), open, "Flights of " + by));
}

// The folder says which flights come too near, and so does the exit code.
cli::Exit told_of_pairs(const std::optional<traj::FlightPairs>& pairs) {
  if (!pairs || pairs->refused == 0) return cli::Exit::yes;
  cli::complain("skyway-submit",
                fmt::format("{} of {} of flights come too near to one another: pairs.jsonl and the "
                            "summary name them",
                            pairs->refused, geom::counted(pairs->compared, "pair")));
  return cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Make a folder for an authority: flights, volumes, risk and proofs.",
               "skyway-submit"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.require_sound(app);
    const std::string operation_text = text_of(options.operation);
    const traj::Operation operation = traj::read_operation(operation_text, options.operation);
    cli::Scenes scenes(cli::open_map(options.map, geom::Verified::contents), options.vehicle,
                       cli::Scenes::Differences::refused);
    traj::Submission submission{.made_by = kMadeBy};
    submission.method = options.method(operation, scenes.map().spec(), scenes.map().hash());
    submission.zones = traj::zones_of(scenes.map().spec());
    submission.doubts = geom::doubts_of(scenes.map().spec());
    SubmissionFolder folder(options.folder);
    folder.add("map.boxmap", text_of(options.map));
    folder.add("operation.json", operation_text);
    const auto tubes = submitting::take_tubes(options.tube, submission.method, folder);
    traj::MethodFiles files = method_files(options, scenes.map().spec(), submission.method, folder);
    if (tubes) files.tubes = &*tubes;
    const auto ground = ground_of(options, scenes.map(), submission.method, folder);
    if (ground) files.ground = &*ground;
    const traj::SubmittedFlights open(scenes, submission.method, files);
    FlightFiles flights(common, open, folder, submission.method.together);
    for (const std::string& file : options.flights) flights.add(file, scenes.map());
    require_used(app, submission.method, flights);
    flights.write();
    if (flights.refused() > 0) {
      cli::complain("skyway-submit",
                    fmt::format("{} of {} refused: no folder was made", flights.refused(),
                                geom::counted(flights.refused() + flights.count(), "flight")));
      return cli::Exit::no;
    }
    submission.flights = flights.count();
    submission.pairs = compared(common, flights, submission.method);
    submission.missions = flights.missions();
    if (!options.population.empty()) {
      submitting::count_people(options.population, flights, submission, folder);
    }
    write_claims(flights.claims(), folder);
    folder.add("submission.json", traj::to_json_line(submission));
    folder.add("summary.html", traj::summary_page(operation, submission, flights.claims()));
    for (const auto& one : traj::verify_scripts())
      folder.add(fmt::format("verify/{}", one.name), one.text);
    if (!options.no_page) add_page(common, flights, open, operation.by.name, folder);
    const std::size_t bytes = folder.bytes();
    const std::string hash = folder.commit(kMadeBy);
    cli::tell(common, "skyway-submit",
              fmt::format("{} in {} files, {:.1f} MB; the manifest's SHA-256 is {}",
                          geom::counted(flights.count(), "flight"), folder.files(),
                          1e-6 * static_cast<double>(bytes), hash));
    common.write_stats({{"flights", flights.count()},
                        {"files", folder.files()},
                        {"bytes", bytes},
                        {"manifest_sha256", hash}});
    return told_of_pairs(submission.pairs);
  });
}
