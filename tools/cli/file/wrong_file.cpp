#include "wrong_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geom/gis/footprint_format.h"
#include "geom/import/import_boxes.h"
#include "geom/text/spoken_list.h"
#include "recognise.h"
#include "run_files.h"
#include "traj/files/drone_formats.h"
#include "traj/files/foreign_formats.h"
#include "traj/files/own_formats.h"
#include "traj/mission/formats/mission_format.h"
#include "traj/mission/formats/mission_formats.h"

namespace cli {
namespace {

using geom::Format;
using geom::gis::kGeoJsonFeature;
using geom::gis::kGeoJsonFile;
namespace known = traj::files;

// What an option or argument takes.
struct Place {
  std::string_view tool;    // empty: of every tool
  std::string_view option;  // as the parser names it
  std::vector<const Format*> takes;
  std::vector<std::string_view> unless = {};  // options that make it take other files, too
  bool drone_files = false;                   // whether it takes these and flight logs, too
};

const std::array kPlaces = {
    Place{"", "map", {&known::kBoxMap}},
    Place{"", "maps", {&known::kBoxMap}},
    Place{"", "before", {&known::kBoxMap}},
    Place{"", "after", {&known::kBoxMap}},
    Place{"", "--lattice", {&known::kLattice}},
    Place{"", "--roadmap", {&known::kRoadmap}},
    Place{
        "", "--queries", {&known::kQueries, &known::kQueryTable, &kGeoJsonFeature, &kGeoJsonFile}},
    Place{"", "--vehicle", {&known::kVehicleProfile}},
    Place{"", "--moving", {&known::kMoving}},
    Place{"", "--ground-model", {&known::kGround}},
    Place{"skyway-traj", "paths", {&known::kPaths}},
    Place{"skyway-replan", "--paths", {&known::kPaths}},
    Place{"skyway-check",
          "file",
          {&known::kTrajectories, &known::kPaths},
          {"--file-format", "--paths-csv"},
          true},
    Place{"skyway-submit", "flights", {&known::kTrajectories, &known::kFlights}, {}, true},
    Place{"skyway-fleet", "file", {&known::kTrajectories}},
    Place{"skyway-fleet", "--alternatives", {&known::kTrajectories}},
    Place{"skyway-fleet", "--others", {&known::kTrajectories}},
    Place{"skyway-join", "shards", {&known::kShard}},
    Place{"skyway-map", "--add", {geom::kBoxCsv.format}},
    Place{"skyway-map", "--keep-out", {&kGeoJsonFile, &kGeoJsonFeature}},
    Place{
        "skyway-map", "--fence", {&traj::kQgcPlan.format, &traj::kWpl.format, &known::kFenceText}},
};

// Of two files that one argument takes, a map and what flies.
const Place kFirst{"", "map_and_file", {&known::kBoxMap}};
const Place kSecond{"", "map_and_file", {&known::kTrajectories}};
const Place kSecondOfExport{
    "skyway-export", "map_and_file", {&known::kTrajectories, &known::kPaths}};

const Place& second_of(const CLI::App& app) {
  return app.get_name() == kSecondOfExport.tool ? kSecondOfExport : kSecond;
}

// How what is expected is made of what was found.
struct Step {
  const Format* expected;  // null: anything
  const Format* found;     // null: of anything else
  std::string_view advice;
};

constexpr std::array kSteps = {
    Step{nullptr, &known::kShard, "skyway-join puts the shards of a run together"},
    Step{nullptr, &known::kFlightLog, "skyway-check holds it against a map"},
    Step{nullptr, &known::kPx4Log, "skyway-import-flight makes a flight log of it"},
    Step{&known::kPaths, &known::kQueries, "skyway-plan makes paths of them"},
    Step{&known::kPaths, &known::kTrajectories,
         "they are solved already, so prove them with skyway-check or write them with "
         "skyway-export"},
    Step{&known::kPaths, nullptr, "skyway-plan makes paths"},
    Step{&known::kTrajectories, &known::kPaths, "skyway-traj makes trajectories of them"},
    Step{&known::kTrajectories, &known::kQueries,
         "skyway-plan makes paths of them, and skyway-traj trajectories of those"},
    Step{&known::kTrajectories, nullptr, "skyway-traj makes trajectories of paths"},
    Step{&known::kLattice, nullptr, "skyway-lattice makes a lattice of a map"},
    Step{&known::kRoadmap, nullptr, "skyway-roadmap makes a roadmap of a map"},
    Step{&known::kQueries, nullptr,
         R"(a query is a line such as {"id":"a","from":[0,0,10],"to":[50,20,10]})"},
    Step{&known::kMoving, nullptr,
         R"(an obstacle is a line such as {"type":"moving","id":"a","from":0,"until":60,)"
         R"("min":[0,0,9],"max":[4,4,13],"velocity":[1,0,0],"growth":[0,0,0]})"},
    Step{&kGeoJsonFile, &geom::gis::kKmlFile,
         "ogr2ogr -f GeoJSON zones.geojson zones.kml makes GeoJSON of it"},
    Step{&known::kShard, nullptr, "a run with --shard K/N writes shards"},
    Step{&known::kVehicleProfile, nullptr, "data/vehicles has some to begin with"},
};

// A value of an option or argument.
struct Value {
  const CLI::Option* option;
  std::size_t index;
  std::string text;
};

void add_values(const CLI::App& app, std::vector<Value>& out) {
  for (const CLI::Option* option : app.get_options()) {
    const auto& results = option->results();
    for (std::size_t i = 0; i < results.size(); ++i) out.push_back({option, i, results[i]});
  }
  for (const CLI::App* verb : app.get_subcommands()) add_values(*verb, out);
}

std::vector<Value> values_of(const CLI::App& app) {
  std::vector<Value> values;
  add_values(app, values);
  return values;
}

bool is_named(const CLI::Option& option, std::string_view name) {
  return option.check_name(std::string(name));
}

bool takes_more(const CLI::App& app, const Place& place) {
  return std::any_of(place.unless.begin(), place.unless.end(), [&](std::string_view name) {
    const CLI::Option* const option = app.get_option_no_throw(std::string(name));
    return option && option->count() > 0;
  });
}

const Place* place_of(const CLI::App& app, const Value& value) {
  if (is_named(*value.option, "map_and_file")) {
    if (value.option->results().size() < 2) return nullptr;
    return value.index == 0 ? &kFirst : &second_of(app);
  }
  for (const Place& place : kPlaces) {
    if (!place.tool.empty() && place.tool != app.get_name()) continue;
    if (!is_named(*value.option, place.option)) continue;
    return takes_more(app, place) ? nullptr : &place;
  }
  return nullptr;
}

// Of an argument that was left out, and is stdin then.
const Place* place_of_stdin(const CLI::App& app) {
  const auto* const two = app.get_option_no_throw("map_and_file");
  if (two) return two->count() == 1 ? &second_of(app) : nullptr;
  for (const Place& place : kPlaces) {
    if (place.tool != app.get_name()) continue;
    const auto* const option = app.get_option_no_throw(std::string(place.option));
    if (option && option->count() == 0 && !takes_more(app, place)) return &place;
  }
  return nullptr;
}

bool takes(const Place& place, const Format& format) {
  const bool flown = known::is_drone_format(&format) || &format == &known::kFlightLog;
  if (place.drone_files && flown) return true;
  return std::find(place.takes.begin(), place.takes.end(), &format) != place.takes.end();
}

// Of a file that was given in two places, the one that does not take it.
const Place* place_of(const CLI::App& app, const RunFiles::Input& input, const Format& format) {
  const bool standard = input.path == "stdin";
  const Place* found = nullptr;
  for (const Value& value : values_of(app)) {
    if (value.text != (standard ? "-" : input.path)) continue;
    const Place* const place = place_of(app, value);
    if (place && (!found || takes(*found, format))) found = place;
  }
  return found || !standard ? found : place_of_stdin(app);
}

// "a, b and c"; of more than four the first three.
std::string listed(std::span<const std::string_view> tools) {
  std::vector<std::string_view> words(tools.begin(), tools.end());
  if (words.size() > 4) {
    words.resize(3);
    words.push_back("others");
  }
  return geom::spoken_list(words, "and");
}

// Where another argument is what is expected here.
std::string swapped(const CLI::App& app, const Place& place, const std::string& path,
                    const Format& format) {
  for (const Value& other : values_of(app)) {
    if (other.text == path) continue;
    const Format* const found = recognise_file(other.text);
    if (!found || !takes(place, *found)) continue;
    const Place* const its_place = place_of(app, other);
    if (its_place && takes(*its_place, *found)) continue;  // it is where it belongs
    const bool both = !its_place || takes(*its_place, format);
    return fmt::format("{} is {}: {}", other.text, found->what,
                       both ? "swap the two" : "give it here");
  }
  return "";
}

// The tools that make box maps, in the order in which they are offered.
constexpr std::string_view kMakers[] = {"skyway-import", "skyway-footprints", "skyway-cloud",
                                        "skyway-mesh"};

std::string map_of(const Format& format) {
  for (const std::string_view maker : kMakers) {
    if (reads(maker, format)) return fmt::format("{} makes a box map of it", maker);
  }
  if (format.readers.empty() && !format.advice.empty()) return std::string(format.advice);
  return "skyway-import, skyway-footprints and skyway-cloud make box maps";
}

std::string made_of(const Place& place, const Format& format) {
  const Format* const wanted = place.takes.front();
  if (wanted == &known::kBoxMap && &format != &known::kShard) return map_of(format);
  if (known::is_drone_format(&format) &&
      (wanted == &known::kPaths || wanted == &known::kTrajectories)) {
    return "skyway-import-trajectory makes records of it";
  }
  for (const Step& step : kSteps) {
    const bool right = !step.expected || step.expected == wanted;
    if (right && (!step.found || step.found == &format)) return std::string(step.advice);
  }
  return "";
}

// What to do with the file itself.
std::string use_of(const Format& format) {
  if (format.readers.empty()) return std::string(format.advice);
  return fmt::format("{} {}", listed(format.readers), format.readers.size() == 1 ? "does" : "do");
}

// A file of this run, as messages call it.
struct Found {
  const std::string& path;
  const Format& format;
  std::string what;
};

std::string refusal_here(const CLI::App& app, const Place& place, const Found& found) {
  const Format& format = found.format;
  std::vector<std::string_view> taken;
  for (const Format* one : place.takes) taken.push_back(one->what);
  if (place.drone_files) taken.emplace_back("a drone file");
  std::string advice = swapped(app, place, found.path, format);
  if (advice.empty()) advice = made_of(place, format);
  if (advice.empty() && !format.readers.empty()) {
    advice = fmt::format("{} {} it", listed(format.readers),
                         format.readers.size() == 1 ? "reads" : "read");
  }
  return fmt::format("{}: expected {}, found {}{}{}", found.path, geom::spoken_list(taken, "or"),
                     found.what, advice.empty() ? "" : "; ", advice);
}

std::string refusal_by_tool(const std::string& tool, const Found& found) {
  const bool maker = std::find(std::begin(kMakers), std::end(kMakers), tool) != std::end(kMakers);
  const std::string advice = maker && &found.format == &known::kBoxMap
                                 ? "it is a map already, which skyway-map changes"
                                 : use_of(found.format);
  return fmt::format("{}: this is {}, which {} does not read{}{}", found.path, found.what, tool,
                     advice.empty() ? "" : "; ", advice);
}

}  // namespace

std::optional<std::string> wrong_file(const CLI::App& app, std::string_view source) {
  const RunFiles* const files = RunFiles::current();
  if (!files) return std::nullopt;
  const auto& inputs = files->inputs();
  const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const auto& one) {
    return source == one.path || source.starts_with(one.path + ": ");  // or a part of it
  });
  if (input == inputs.end()) return std::nullopt;
  const bool standard = input->path == "stdin";
  const Format* const format =
      standard ? known::recognise(input->head) : recognise_file(input->path);
  if (!format) return std::nullopt;
  // An autopilot's parameters may be those of its log.
  const CLI::Option* const params = app.get_option_no_throw("--params");
  const bool of_params = params && params->count() > 0 && params->as<std::string>() == input->path;
  if (of_params && head_of(input->path).starts_with("ULog")) return std::nullopt;
  const Found found{input->path, *format,
                    known::described(*format, standard ? input->head : head_of(input->path))};
  if (const Place* const place = place_of(app, *input, *format)) {
    if (takes(*place, *format)) return std::nullopt;
    return refusal_here(app, *place, found);
  }
  if (reads(app.get_name(), *format)) return std::nullopt;
  return refusal_by_tool(app.get_name(), found);
}

}  // namespace cli
