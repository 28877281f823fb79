#include "traj/submit/check_submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "folder_files.h"
#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "geom/map/box_map_file.h"
#include "geom/map/ground_model.h"
#include "geom/record/scenes.h"
#include "geom/text/counted.h"
#include "geom/text/json_line.h"
#include "traj/mission/firmware/autopilot.h"
#include "traj/record/verdict.h"
#include "traj/submit/flight_pairs.h"
#include "traj/submit/manifest.h"
#include "traj/submit/operation.h"
#include "traj/submit/population.h"
#include "traj/submit/risk_geojson.h"
#include "traj/submit/submitted_flights.h"
#include "traj/submit/summary_page.h"
#include "traj/submit/verify_scripts.h"

namespace traj {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr std::size_t kFolderFlights = 64;  // flights at a time

using Refusal = FolderRefusal;

class Folder {
 public:
  Folder(const fs::path& path, const SubmissionRun& run) : files_(path, run.open), run_(run) {}

  SubmissionCheck check() {
    SubmissionCheck out;
    try {
      out.refusal = refusal();
    } catch (const geom::UsageError& error) {  // what was asked for stands in the folder
      out.refusal = Refusal{"submission.json", error.what()};
    }
    out.manifest = hash_;
    out.flights = claims_.size();
    out.files = listed_.size() + 1;
    out.not_verified = not_verified_;
    return out;
  }

 private:
  std::optional<Refusal> refusal() {
    if (auto why = why_files_differ()) return why;
    read();
    if (auto why = why_not_known()) return why;
    if (auto why = why_method_differs()) return why;
    if (auto why = why_flights_refused()) return why;
    if (summary_page(operation_, submission_, claims_) != file("summary.html")) {
      return Refusal{"summary.html", "it does not say what the other files say"};
    }
    if (auto why = why_scripts_differ()) return why;
    if (auto why = why_too_near()) return why;
    geom::require_unchanged(*map_);
    return std::nullopt;
  }

  // --- files ----------------------------------------------------------------------------------

  std::string name_of(const std::string& name) const { return files_.name_of(name); }
  std::string file(const std::string& name) const { return files_.text_of(name); }
  bool has(const std::string& name) const { return names_.contains(name); }

  std::optional<Refusal> why_files_differ() {
    const std::string manifest = file(kManifest);
    hash_ = listed_file(kManifest, manifest).sha256;
    listed_ = read_manifest(manifest, name_of(kManifest));
    std::vector<ListedFile> found;
    for (const auto& entry : fs::recursive_directory_iterator(files_.path())) {
      const std::string name = entry.path().lexically_relative(files_.path()).generic_string();
      if (entry.is_directory() && !entry.is_symlink()) continue;
      if (entry.is_symlink() || !entry.is_regular_file()) {
        return Refusal{name, "it is a link or a device, and no file"};
      }
      if (name != kManifest) found.push_back(files_.listed(name));
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.path < b.path; });
    if (const auto why = why_not_as_listed(listed_, found)) return Refusal{kManifest, *why};
    for (const ListedFile& one : listed_) names_.insert(one.path);
    files_.hold(listed_);
    return std::nullopt;
  }

  void read() {
    for (const char* name :
         {"map.boxmap", "operation.json", "submission.json", "claims.jsonl", "summary.html"}) {
      if (has(name)) continue;
      throw geom::InputError(name_of(""),
                             {.expected = fmt::format("the file {}", name), .found = "none"});
    }
    operation_ = read_operation(file("operation.json"), name_of("operation.json"));
    submission_ = read_submission(file("submission.json"), name_of("submission.json"));
    std::size_t number = 0;
    for (const std::string& line : lines_of(file("claims.jsonl"))) {
      claims_.push_back(parse_flight_claims(line, name_of("claims.jsonl"), ++number));
    }
  }

  // That submission.json speaks of.
  std::set<std::string> needed() const {
    std::set<std::string> out;
    if (submission_.method.params) out.insert(kParamsFile);
    if (submission_.method.geoid_grid) out.insert(kGeoidFile);
    if (submission_.pairs) {
      out.insert("pairs.jsonl");
      if (submission_.pairs->refused == 0) out.insert("pair_certificates.jsonl");
    }
    if (submission_.population) out.insert("population.csv");
    if (submission_.method.tubes) out.insert(kTubesFile);
    if (submission_.method.ground_model) out.insert(kGroundFile);
    for (const std::string& mission : submission_.missions) out.insert("missions/" + mission);
    return out;
  }

  // Every file of the manifest is one whose content is looked at, or is told.
  std::optional<Refusal> why_not_known() {
    std::set<std::string> known = needed();
    for (const std::string& name : known) {
      if (!has(name)) return Refusal{name, "it is missing"};
    }
    known.insert({"map.boxmap", "operation.json", "submission.json", "claims.jsonl", "summary.html",
                  "page.html", "flights.jsonl", "certificates.jsonl"});
    for (const FlightClaims& one : claims_) {
      known.insert(one.volumes);
      known.insert(one.risk);
    }
    for (const VerifyScript& one : verify_scripts()) {
      known.insert("verify/" + std::string(one.name));
    }
    for (const std::string& name : names_) {
      if (!known.contains(name)) return Refusal{name, "no part of such a folder has that name"};
    }
    if (has("page.html")) not_verified_.push_back("page.html");
    if (submission_.population) {
      not_verified_.push_back("that population.csv is of " + submission_.population->name);
    }
    if (submission_.method.ground_model) {
      not_verified_.push_back(
          fmt::format("that {} is of {}", kGroundFile, submission_.method.ground_model->name));
    }
    return std::nullopt;
  }

  // --- what was asked for ---------------------------------------------------------------------

  std::optional<Refusal> why_method_differs() {
    if (to_json_line(submission_) != file("submission.json")) {
      return Refusal{
          "submission.json",
          "skyway-submit does not write it so: a member is unknown, or its form is another"};
    }
    const SubmissionMethod& method = submission_.method;
    map_.emplace(map_of(name_of("map.boxmap")));
    if (method.made_for.map != map_->hash() || method.made_for.frame != map_->spec().frame.axes) {
      return Refusal{"submission.json",
                     fmt::format("it is for another map than map.boxmap, {}", map_->hash())};
    }
    if (zones_of(map_->spec()) != submission_.zones) {
      return Refusal{"submission.json", "its zones are not those that the map's history names"};
    }
    if (!(geom::doubts_of(map_->spec()) == submission_.doubts)) {
      return Refusal{"submission.json", "its doubts are not those of the map's history"};
    }
    if (method.risk.dimension != operation_.uas.dimension ||
        method.endurance != operation_.uas.endurance) {
      return Refusal{"submission.json",
                     "its dimension and endurance are not those of the operation"};
    }
    if (!submission_.missions.empty() && !method.made_for.vehicle) {
      return Refusal{"submission.json", "it has missions and no vehicle"};
    }
    if (!autopilots_of(method.autopilot)) {
      return Refusal{"submission.json", "it names an autopilot that nobody knows"};
    }
    if (auto why = why_tubes_differ()) return why;
    if (auto why = why_ground_differs()) return why;
    if (submission_.flights != claims_.size()) {
      return Refusal{"submission.json", fmt::format("it names {} flights, and claims.jsonl {}",
                                                    submission_.flights, claims_.size())};
    }
    if (submission_.population) {
      geom::TextInput in(file("population.csv"));
      const Population population = read_population(in, name_of("population.csv"));
      if (population_csv(population) != file("population.csv")) {
        return Refusal{"population.csv", "its numbers are not written as this program writes them"};
      }
      people_.emplace(population, method.origin);
    }
    return std::nullopt;
  }

  geom::BoxMap map_of(const std::string& path) const {
    geom::BoxMap map = run_.open_map ? run_.open_map(path) : geom::open_map(path);
    map.require(geom::Verified::contents);
    return map;
  }

  // The tubes are believed as skyway-fly reported them: that they are proved stays unverified.
  std::optional<Refusal> why_tubes_differ() {
    const auto& tubes = submission_.method.tubes;
    const GeographyRule rule = submission_.method.risk.geography;
    if (tubes.has_value() != (rule == GeographyRule::proved_tube)) {
      return Refusal{"submission.json",
                     "its geography is of proved tubes, or not, and its tubes are not"};
    }
    if (!tubes) return std::nullopt;
    const std::string text = file(kTubesFile);
    if (listed_file(kTubesFile, text).sha256 != tubes->sha256) {
      return Refusal{kTubesFile,
                     fmt::format("it is not {}, whose hash submission.json has", tubes->name)};
    }
    geom::TextInput in(text);
    tubes_.emplace(TubeReports::read(in, name_of(kTubesFile)));
    not_verified_.push_back(fmt::format("the proofs of the tubes in {}", kTubesFile));
    return std::nullopt;
  }

  // That it is like the world stays an assumption, as of the map.
  std::optional<Refusal> why_ground_differs() {
    const auto& ground = submission_.method.ground_model;
    if (!ground) return std::nullopt;
    if (files_.listed(kGroundFile).sha256 != ground->sha256) {
      return Refusal{kGroundFile,
                     fmt::format("it is not {}, whose hash submission.json has", ground->name)};
    }
    ground_.emplace(geom::read_ground(name_of(kGroundFile)));
    return std::nullopt;
  }

  // --- flights --------------------------------------------------------------------------------

  struct Item {
    std::size_t index = 0;
    std::string text = {};  // its record; empty: a mission
    std::string certificate = {};
    FlightInScene flight = {};
    std::optional<Refusal> refusal = {};
  };

  std::optional<Refusal> why_flights_refused() {
    const SubmissionMethod& method = submission_.method;
    geom::Scenes scenes(*map_, {method.made_for.vehicle, method.made_for.margin},
                        geom::Differences::refused, geom::CollisionOptions().budget);
    MethodFiles files;
    if (method.params) files.params = file(kParamsFile);
    if (method.geoid_grid) files.geoid_grid = file(kGeoidFile);
    if (tubes_) files.tubes = &*tubes_;
    if (ground_) files.ground = &*ground_;
    const SubmittedFlights open(scenes, method, files);
    std::vector<FlightInScene> missions;
    for (const std::string& name : submission_.missions) {
      for (auto& mission : open.of_mission(file("missions/" + name), "missions/" + name)) {
        missions.push_back(std::move(mission));
      }
    }
    TerrainUse use;
    for (const FlightInScene& one : missions) use.take(one.flight->report());
    if (const auto key = use.idle(method)) {
      return Refusal{"submission.json",
                     fmt::format("it says {}, and no mission {}", *key,
                                 *key == kSurfaceBandKey ? "follows the surface"
                                                         : "counts its heights from terrain")};
    }
    if (method.together) set_.emplace(*method.together);
    if (auto why = first_refusal(open, missions)) return why;
    return why_pairs_differ();
  }

  // The flights in their order: records, each with its certificate, and then missions.
  std::optional<Refusal> first_refusal(const SubmittedFlights& open,
                                       std::vector<FlightInScene>& missions) {
    FileLines records = lines_in("flights.jsonl");
    FileLines certificates = lines_in("certificates.jsonl");
    std::optional<Refusal> first;
    std::atomic<bool> refused = false;
    std::size_t count = 0;
    std::size_t of_missions = 0;
    const auto next = [&]() -> std::optional<Item> {
      if (refused) return std::nullopt;
      auto text = records.next();
      auto certificate = certificates.next();
      Item item{count};
      if (text.has_value() != certificate.has_value()) {
        item.refusal =
            Refusal{"certificates.jsonl", "it and flights.jsonl have other numbers of lines"};
      } else if (text) {
        item.text = *std::move(text);
        item.certificate = *std::move(certificate) + '\n';
      } else if (of_missions < missions.size()) {
        item.flight = std::move(missions[of_missions++]);
      } else {
        return std::nullopt;
      }
      if (count++ >= claims_.size()) item.refusal = too_many_flights();
      return item;
    };
    const auto work = [&](Item& item) {
      if (item.refusal) return;
      if (!item.flight.flight) {
        item.flight = open.of_record(item.text, name_of("flights.jsonl"), item.index + 1);
      }
      item.refusal = why_refused(*item.flight.flight, claims_[item.index], item.certificate);
    };
    geom::in_order<Item>(run_.flights, kFolderFlights, next, work, [&](Item& item) {
      if (!first) first = std::move(item.refusal);
      refused = first.has_value();
      if (set_ && !first) take(item);
    });
    if (!first && count != claims_.size()) first = too_many_flights();
    return first;
  }

  FileLines lines_in(const std::string& name) const {
    return has(name) ? files_.lines_in(name) : FileLines();
  }

  Refusal too_many_flights() const {
    return {"claims.jsonl", fmt::format("it has {}, and there are more or fewer flights",
                                        geom::counted(claims_.size(), "line"))};
  }

  void take(const Item& item) {
    const auto* record = dynamic_cast<const SubmittedTrajectory*>(item.flight.flight.get());
    if (record) record->add_to(*set_, name_of("flights.jsonl"), item.index + 1);
  }

  // Flights against one another.
  std::optional<Refusal> why_pairs_differ() {
    if (!set_ != !submission_.pairs) {
      return Refusal{"submission.json", "it asks for pairs and names none, or the other way round"};
    }
    if (!set_) return std::nullopt;
    const ComparedFlights compared = compare_flights(*set_, run_.pairs);
    if (compared.found != *submission_.pairs) {
      return Refusal{
          "submission.json",
          fmt::format("of {} of flights {} come too near, and it says another number "
                      "or names others",
                      geom::counted(compared.found.compared, "pair"), compared.found.refused)};
    }
    if (file("pairs.jsonl") != compared.records) {
      return Refusal{"pairs.jsonl", "it does not say what the flights say"};
    }
    if (compared.found.refused > 0) return std::nullopt;
    if (file("pair_certificates.jsonl") != compared.certificates) {
      return Refusal{"pair_certificates.jsonl", "it does not hold the reasons of the proof"};
    }
    return std::nullopt;
  }

  std::optional<Refusal> why_refused(const SubmittedFlight& flight, const FlightClaims& claims,
                                     const std::string& certificate) const {
    const std::string& id = flight.report().id;
    if (const std::string why = flight.refusal(); !why.empty()) {
      return Refusal{
          "flights.jsonl",
          id + ": " + (accepted(flight.report()) ? why : in_words(flight.report(), *map_))};
    }
    if (!has(claims.volumes) || !has(claims.risk)) {
      return Refusal{"claims.jsonl", id + ": its volumes or risk volumes are not in the folder"};
    }
    const std::string volumes = file(claims.volumes);
    geom::TextInput in(volumes);
    const geom::IntentVolumes intent = geom::read_intent_volumes(in, name_of(claims.volumes));
    if (volumes_json(intent) != volumes) {
      return Refusal{claims.volumes, "it is not written as this program writes volumes"};
    }
    if (const auto why = flight.why_not_held(intent)) return Refusal{claims.volumes, *why};
    if (auto why = why_risk_differs(flight, intent, claims)) return why;
    const auto* trajectory = dynamic_cast<const SubmittedTrajectory*>(&flight);
    if (trajectory && trajectory->certificate() != certificate) {
      return Refusal{"certificates.jsonl", id + ": its certificate is not the one of its proof"};
    }
    return std::nullopt;
  }

  std::optional<Refusal> why_risk_differs(const SubmittedFlight& flight,
                                          const geom::IntentVolumes& intent,
                                          const FlightClaims& claims) const {
    const std::string text = file(claims.risk);
    const ReadRisk risk = read_risk_geojson(text, name_of(claims.risk));
    if (risk_geojson(flight.report().id, intent, risk.volumes) != text) {
      return Refusal{claims.risk,
                     "it is of another flight, or its flight geography is not that of "
                     "the volumes"};
    }
    const RiskTask task = flight.risk_task();
    if (const auto why = why_risk_not_held(intent, risk.volumes, task, claims.risk)) {
      return Refusal{claims.risk, *why};
    }
    FlightClaims derived = flight.claims(intent, risk.volumes);
    derived.volumes = claims.volumes;
    derived.risk = claims.risk;
    if (people_) {
      const Exposed exposed = people_->exposed(risk.volumes.buffers);
      if (!exposed.inside) {
        return Refusal{"population.csv", claims.id +
                                             ": its cells do not reach as far as the "
                                             "ground risk buffer"};
      }
      derived.people = exposed.people;
      derived.people_unknown = exposed.unknown;
    }
    const std::string expected = to_json_line(derived);
    if (to_json_line(claims) == expected) return std::nullopt;
    return Refusal{"claims.jsonl", fmt::format("{}: what follows from the other files is {}",
                                               claims.id, expected.substr(0, expected.size() - 1))};
  }

  // What the folder says of itself.
  std::optional<Refusal> why_too_near() const {
    const auto& pairs = submission_.pairs;
    if (!pairs || pairs->refused == 0) return std::nullopt;
    return Refusal{"pairs.jsonl",
                   fmt::format("{} of {} of flights come too near, as the folder says itself; the "
                               "first: {} and {}",
                               pairs->refused, geom::counted(pairs->compared, "pair"),
                               pairs->named.front()[0], pairs->named.front()[1])};
  }

  // --- scripts --------------------------------------------------------------------------------

  std::optional<Refusal> why_scripts_differ() {
    for (const VerifyScript& one : verify_scripts()) {
      const std::string name = "verify/" + std::string(one.name);
      if (!has(name) || file(name) == one.text) continue;
      if (submission_.made_by == "skyway " SKYWAY_VERSION) {
        return Refusal{name, "it is not the script of this version of Skyway"};
      }
      not_verified_.push_back(name);
    }
    return std::nullopt;
  }

  FolderFiles files_;
  const SubmissionRun& run_;
  std::string hash_;
  std::vector<ListedFile> listed_;
  std::set<std::string> names_;
  Operation operation_;
  Submission submission_;
  std::vector<FlightClaims> claims_;
  std::optional<geom::BoxMap> map_;
  std::optional<PopulationOnMap> people_;
  std::optional<FlightSet> set_;  // of trajectories, where they are compared
  std::optional<TubeReports> tubes_;
  std::optional<geom::GroundModel> ground_;
  std::vector<std::string> not_verified_;
};

}  // namespace

SubmissionCheck check_submission(const fs::path& folder, const SubmissionRun& run) {
  return Folder(folder, run).check();
}

std::string to_json_line(const SubmissionCheck& check) {
  geom::JsonLine line;
  line.add("type", "folder_report").add("ok", check.ok()).add("manifest", check.manifest);
  if (!check.ok()) {
    line.add("file", check.refusal->file).add("reason", check.refusal->why);
  } else {
    line.add("flights", check.flights)
        .add("files", check.files)
        .add("not_verified", check.not_verified);
  }
  return line.line();
}

}  // namespace traj
