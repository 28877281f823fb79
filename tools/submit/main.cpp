// skyway-submit: a folder for an authority, with flights, volumes and proofs.

#include <fmt/format.h>

#include "cli/content/verify_scripts.h"
#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "flight_files.h"
#include "geom/text/counted.h"
#include "options.h"
#include "people.h"
#include "submission_folder.h"
#include "traj/submit/summary_page.h"
#include "tubes.h"
#include "view_page.h"

namespace {

using submitting::FlightFiles;
using submitting::Options;
using submitting::SubmissionFolder;

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
    SubmissionFolder folder(options.folder);
    folder.add("map.boxmap", text_of(options.map));
    folder.add("operation.json", operation_text);
    const auto tubes = submitting::take_tubes(options.tube, submission.method, folder);
    const cli::SubmittedFlights open(scenes, submission.method, tubes ? &*tubes : nullptr);
    FlightFiles flights(common, open, folder);
    for (const std::string& file : options.flights) flights.add(file, scenes.map());
    flights.write();
    if (flights.refused() > 0) {
      cli::complain("skyway-submit",
                    fmt::format("{} of {} refused: no folder was made", flights.refused(),
                                geom::counted(flights.refused() + flights.count(), "flight")));
      return cli::Exit::no;
    }
    submission.flights = flights.count();
    submission.missions = flights.missions();
    if (!options.population.empty()) {
      submitting::count_people(options.population, flights, submission, folder);
    }
    write_claims(flights.claims(), folder);
    folder.add("submission.json", traj::to_json_line(submission));
    folder.add("summary.html", traj::summary_page(operation, submission, flights.claims()));
    for (const cli::VerifyScript& one : cli::verify_scripts()) {
      folder.add("verify/" + std::string(one.name), one.text);
    }
    if (!options.no_page) {
      folder.add("page.html",
                 submitting::view_page(common, shown_files(flights, folder), submission.method,
                                       "Flights of " + operation.by.name));
    }
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
    return cli::Exit::yes;
  });
}
