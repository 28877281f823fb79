#include "wrong_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "recognise.h"
#include "run_files.h"

namespace cli {
namespace {

constexpr std::string_view kMap = "a box map";
constexpr std::string_view kPaths = "a stream of paths";
constexpr std::string_view kTrajectories = "a stream of trajectories";
constexpr std::string_view kQueries = "a stream of queries";
constexpr std::string_view kZones = "a GeoJSON file";
constexpr std::string_view kMoving = "a stream of obstacles that move";

// What an option or argument takes, by how recognise() calls it.
struct Place {
  std::string_view tool;    // empty: of every tool
  std::string_view option;  // as the parser names it
  std::vector<std::string_view> takes;
  std::vector<std::string_view> unless = {};  // options that make it take other files, too
};

const std::array kPlaces = {
    Place{"", "map", {kMap}},
    Place{"", "maps", {kMap}},
    Place{"", "before", {kMap}},
    Place{"", "after", {kMap}},
    Place{"", "--lattice", {"a lattice"}},
    Place{"", "--roadmap", {"a roadmap"}},
    Place{"", "--queries", {kQueries, "a table of queries", "a GeoJSON feature", "a GeoJSON file"}},
    Place{"", "--vehicle", {"a vehicle profile"}},
    Place{"", "--moving", {kMoving}},
    Place{"skyway-traj", "paths", {kPaths}},
    Place{"skyway-replan", "--paths", {kPaths}},
    Place{"skyway-check", "file", {kTrajectories, kPaths}, {"--file-format", "--paths-csv"}},
    Place{"skyway-fleet", "file", {kTrajectories}},
    Place{"skyway-fleet", "--alternatives", {kTrajectories}},
    Place{"skyway-fleet", "--others", {kTrajectories}},
    Place{"skyway-join", "shards", {"a shard"}},
    Place{"skyway-map", "--add", {"a table of boxes (box CSV)"}},
    Place{"skyway-map", "--keep-out", {kZones, "a GeoJSON feature"}},
    Place{
        "skyway-map",
        "--fence",
        {"a QGroundControl plan", "a mission (WPL)", "a fence or rally points without a mission"}},
};

// Of two files that one argument takes, a map and what flies.
const Place kFirst{"", "map_and_file", {kMap}};
const Place kSecond{"", "map_and_file", {kTrajectories}};
const Place kSecondOfExport{"skyway-export", "map_and_file", {kTrajectories, kPaths}};

const Place& second_of(const CLI::App& app) {
  return app.get_name() == kSecondOfExport.tool ? kSecondOfExport : kSecond;
}

// How what is expected is made of what was found.
struct Step {
  std::string_view expected;  // empty: anything
  std::string_view found;     // empty: of anything else
  std::string_view advice;
};

constexpr std::array kSteps = {
    Step{"", "a shard", "skyway-join puts the shards of a run together"},
    Step{"", "a flight log", "skyway-check --file-format flight-log holds it against a map"},
    Step{"", "a PX4 flight log (ULog)", "skyway-import-flight makes a flight log of it"},
    Step{kPaths, kQueries, "skyway-plan makes paths of them"},
    Step{kPaths, kTrajectories,
         "they are solved already, so prove them with skyway-check or write them with "
         "skyway-export"},
    Step{kPaths, "", "skyway-plan makes paths"},
    Step{kTrajectories, kPaths, "skyway-traj makes trajectories of them"},
    Step{kTrajectories, kQueries,
         "skyway-plan makes paths of them, and skyway-traj trajectories of those"},
    Step{kTrajectories, "", "skyway-traj makes trajectories of paths"},
    Step{"a lattice", "", "skyway-lattice makes a lattice of a map"},
    Step{"a roadmap", "", "skyway-roadmap makes a roadmap of a map"},
    Step{kQueries, "", R"(a query is a line such as {"id":"a","from":[0,0,10],"to":[50,20,10]})"},
    Step{kMoving, "",
         R"(an obstacle is a line such as {"type":"moving","id":"a","from":0,"until":60,)"
         R"("min":[0,0,9],"max":[4,4,13],"velocity":[1,0,0],"growth":[0,0,0]})"},
    Step{kZones, "a KML file", "ogr2ogr -f GeoJSON zones.geojson zones.kml makes GeoJSON of it"},
    Step{"a shard", "", "a run with --shard K/N writes shards"},
    Step{"a vehicle profile", "", "data/vehicles has some to begin with"},
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

bool takes(const Place& place, const FileKind& kind) {
  return std::find(place.takes.begin(), place.takes.end(), kind.what) != place.takes.end();
}

// Of a file that was given in two places, the one that does not take it.
const Place* place_of(const CLI::App& app, const RunFiles::Input& input, const FileKind& kind) {
  const bool standard = input.path == "stdin";
  const Place* found = nullptr;
  for (const Value& value : values_of(app)) {
    if (value.text != (standard ? "-" : input.path)) continue;
    const Place* const place = place_of(app, value);
    if (place && (!found || takes(*found, kind))) found = place;
  }
  return found || !standard ? found : place_of_stdin(app);
}

std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> words;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    words.push_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return words;
}

// "a, b and c"; of more than four the first three.
std::string listed(std::vector<std::string_view> words) {
  if (words.size() > 4) {
    words.resize(3);
    words.push_back("others");
  }
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    out += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + std::string(words[i]);
  }
  return out;
}

// Where another argument is what is expected here.
std::string swapped(const CLI::App& app, const Place& place, const std::string& path,
                    const FileKind& kind) {
  for (const Value& other : values_of(app)) {
    if (other.text == path) continue;
    const auto found = recognise_file(other.text);
    if (!found || !takes(place, *found)) continue;
    const Place* const its_place = place_of(app, other);
    if (its_place && takes(*its_place, *found)) continue;  // it is where it belongs
    const bool both = !its_place || takes(*its_place, kind);
    return fmt::format("{} is {}: {}", other.text, found->what,
                       both ? "swap the two" : "give it here");
  }
  return "";
}

std::string made_of(const Place& place, const FileKind& kind) {
  if (place.takes.front() == kMap && kind.what != "a shard") {
    for (const std::string_view maker :
         {"skyway-import", "skyway-footprints", "skyway-cloud", "skyway-mesh"}) {
      const auto tools = words_of(kind.tools);
      if (std::find(tools.begin(), tools.end(), maker) == tools.end()) continue;
      return fmt::format("{} makes a box map of it", maker);
    }
    if (kind.tools.empty() && !kind.otherwise.empty()) return std::string(kind.otherwise);
    return "skyway-import, skyway-footprints and skyway-cloud make box maps";
  }
  const bool drone_file = kind.tools.starts_with(kDroneTools);
  if (drone_file && !place.unless.empty())
    return fmt::format("{} auto reads it", place.unless.front());
  if (drone_file && (place.takes.front() == kPaths || place.takes.front() == kTrajectories)) {
    return "skyway-import-trajectory makes records of it";
  }
  for (const Step& step : kSteps) {
    const bool right = step.expected.empty() || step.expected == place.takes.front();
    if (right && (step.found.empty() || step.found == kind.what)) return std::string(step.advice);
  }
  return "";
}

// What to do with the file itself.
std::string use_of(const FileKind& kind) {
  if (kind.tools.empty()) return std::string(kind.otherwise);
  const auto tools = words_of(kind.tools);
  return fmt::format("{} {}", listed(tools), tools.size() == 1 ? "does" : "do");
}

std::string refusal_here(const CLI::App& app, const Place& place, const std::string& path,
                         const FileKind& kind) {
  std::string expected(place.takes.front());
  for (std::size_t i = 1; i < place.takes.size(); ++i) {
    expected += (i + 1 < place.takes.size() ? ", " : " or ") + std::string(place.takes[i]);
  }
  std::string advice = swapped(app, place, path, kind);
  if (advice.empty()) advice = made_of(place, kind);
  if (advice.empty() && !kind.tools.empty()) {
    const auto tools = words_of(kind.tools);
    advice = fmt::format("{} {} it", listed(tools), tools.size() == 1 ? "reads" : "read");
  }
  return fmt::format("{}: expected {}, found {}{}{}", path, expected, kind.what,
                     advice.empty() ? "" : "; ", advice);
}

std::string refusal_by_tool(const std::string& tool, const std::string& path,
                            const FileKind& kind) {
  const bool maker = tool == "skyway-import" || tool == "skyway-footprints" ||
                     tool == "skyway-cloud" || tool == "skyway-mesh";
  const std::string advice =
      maker && kind.what == kMap ? "it is a map already, which skyway-map changes" : use_of(kind);
  return fmt::format("{}: this is {}, which {} does not read{}{}", path, kind.what, tool,
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
  const auto kind = standard ? recognise(input->head) : recognise_file(input->path);
  const std::string& tool = app.get_name();
  if (!kind || reads(kind->named_by, tool)) return std::nullopt;
  if (const Place* const place = place_of(app, *input, *kind)) {
    if (takes(*place, *kind)) return std::nullopt;
    return refusal_here(app, *place, input->path, *kind);
  }
  if (reads(kind->tools, tool)) return std::nullopt;
  return refusal_by_tool(tool, input->path, *kind);
}

}  // namespace cli
