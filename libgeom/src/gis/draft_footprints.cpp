#include "geom/gis/draft_footprints.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/unchanged_file.h"
#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/gis/place_footprints.h"
#include "geom/gis/read_footprints.h"
#include "map/history_step.h"

namespace geom::gis {
namespace {

std::string hash_of(const std::string& path, const OpenFile& open) {
  const auto file = open(path);
  return HashedStream(*file).hash();
}

// By their names alone, which are the same in any folder.
HistoryStep hashes_of(const std::vector<std::string>& paths, const OpenFile& open) {
  HistoryStep out;
  for (const std::string& path : paths) {
    out[std::filesystem::path(path).filename().string()] = hash_of(path, open);
  }
  return out;
}

// Buildings end at their walls and roofs, so there is room around and above them. A height model
// has no such end: nobody knows what is beside it.
MakeMapOptions with_room(MakeMapOptions map, const FootprintFormat& format) {
  if (map.bounds || &format == &kRaster) return map;
  if (!map.ceiling && !map.pad) map.headroom = kDefaultHeadroom;
  if (!map.pad) map.pad = kDefaultPad;
  return map;
}

// The words of the defaults that the bounds came from.
std::vector<std::string> defaulted(const MakeMapOptions& asked, const MakeMapOptions& used) {
  std::vector<std::string> words;
  if (used.pad != asked.pad) words.emplace_back("pad");
  if (used.headroom) words.emplace_back("headroom");
  return words;
}

void tell_room(const MakeMapOptions& asked, const MakeMapOptions& used, const std::string& name,
               const Notes& notes) {
  std::string room;
  if (used.pad != asked.pad) room = fmt::format("{} m beyond the outermost wall", *used.pad);
  if (used.headroom) room += fmt::format(" and {} m above the highest roof", *used.headroom);
  if (room.empty()) return;
  notes.remark(
      fmt::format("{}: the file has no bounds, so the map reaches {}, where it has no obstacle; "
                  "--pad, --ceiling and --bounds say otherwise",
                  name, room));
}

HistoryStep step_of(const std::string& hash, const FootprintDraftOptions& asked,
                    const FootprintDraftOptions& options, const Source& source) {
  HistoryStep step = {{"tool", "skyway-footprints"},
                      {"input", hash},
                      {"format", options.format->format->word},
                      {"slack", options.read.slack},
                      {"storey", options.read.height.storey},
                      {"default_height", options.read.height.default_height}};
  if (!source.beside.empty()) step["beside"] = hashes_of(source.beside, options.open);
  if (!options.terrain.empty()) step["terrain"] = hash_of(options.terrain, options.open);
  if (!options.read.types.empty()) step["types"] = options.read.types;
  if (!source.left_out.empty()) step["left_out"] = source.left_out;
  if (options.read.height_unit) step["height_units_m"] = *options.read.height_unit;
  add_options(step, options.map);
  const std::vector<std::string> words = defaulted(asked.map, options.map);
  if (!words.empty()) step["defaulted"] = words;
  return step;
}

std::size_t left_out_of(const Source& source) {
  std::size_t count = 0;
  for (const auto& [type, n] : source.left_out) count += n;
  return count;
}

std::vector<Fact> facts_of(const Source& source, const FootprintFormat& format) {
  std::vector<Fact> facts = {{"format", std::string(format.format->word)},
                             {"footprints", source.footprints.size()}};
  for (const auto& [what, n] : source.counts) facts.emplace_back(what, n);
  if (!source.skipped.empty()) facts.emplace_back("skipped", source.skipped.count());
  for (const auto& [kind, n] : source.skipped.by_kind()) facts.emplace_back("skipped: " + kind, n);
  if (!source.left_out.empty()) facts.emplace_back("left_out", left_out_of(source));
  for (const auto& [type, n] : source.left_out) facts.emplace_back("left_out: " + type, n);
  return facts;
}

// "649 natural=tree, 96 barrier=fence": the most frequent first, and of many types these alone.
std::string left_out_text(const Source& source) {
  constexpr std::size_t kMost = 12;
  std::vector<std::pair<std::string, std::size_t>> types(source.left_out.begin(),
                                                         source.left_out.end());
  std::stable_sort(types.begin(), types.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  std::size_t left = left_out_of(source);
  for (std::size_t i = 0; i < std::min(kMost, types.size()); ++i) {
    const auto& [type, n] = types[i];
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, type.substr(0, 60));
    left -= n;
  }
  if (left > 0) text += fmt::format(" and {} of {} more types", left, types.size() - kMost);
  return text;
}

// What is not built by its type, and why.
void tell_left_out(const Source& source, const std::string& name, const Notes& notes) {
  if (source.left_out.empty()) return;
  const std::string why =
      source.left_out_rise ? fmt::format(
                                 "they lie on the ground, at most {:.2f} m above its lowest place "
                                 "(--types says what is built)",
                                 *source.left_out_rise)
                           : std::string("--types does not name them");
  notes.warning(fmt::format("{}: left out: {}; {}", name, left_out_text(source), why));
}

// Counts of the file that was read, and facts about it.
void tell(const Source& source, const std::string& name, double default_height,
          const Notes& notes) {
  std::string report;
  for (const auto& [what, n] : source.counts) report += fmt::format("; {}: {}", what, n);
  if (!report.empty()) {
    notes.remark(fmt::format("{}: footprints: {}{}", name, source.footprints.size(), report));
  }
  tell_left_out(source, name, notes);
  for (const std::string& warning : source.warnings) notes.warning(name + ": " + warning);
  if (!source.defaults.empty()) {
    notes.warning(fmt::format("{}: {} m is taken where nothing tells the height: {}", name,
                              default_height, source.defaults.text()));
  }
}

// The floor that the options give, in the footprints' own units.
std::optional<double> floor_of(const MakeMapOptions& map) {
  std::optional<double> floor = map.floor;
  if (map.bounds) floor = map.bounds->min.z();
  if (floor) *floor /= map.scale;
  return floor;
}

// The source in the coordinates of the map, on the ground where there is a terrain.
Frame place(Source& source, const FootprintDraftOptions& options, const std::string& name) {
  if (options.metres && source.crs) {
    throw UsageError(
        fmt::format("--metres is for numbers without a coordinate reference "
                    "system, and {} names one: leave it out",
                    name));
  }
  const double slack = options.read.slack;
  const Projector projector(source, name, options.read.origin, options.metres);
  sink_ground(source.footprints, floor_of(options.map));
  project(source, projector, slack);
  if (!options.terrain.empty()) {
    const Terrain terrain(options.terrain, options.terrain, options.read);
    lift(source, terrain, projector.frame());
  }
  check_sizes(source, slack, name);
  for (const Footprint& f : source.footprints) {
    if (uneven_by(f, slack) > slack / 2) ++source.counts["surfaces_uneven"];
  }
  return projector.frame();
}

// All that is refused, so that nobody mends one thing to hear of the next.
void refuse_at_once(const Source& source, const FootprintDraftOptions& options,
                    const std::string& name) {
  std::string faults;
  if (!source.skipped.empty() && !options.allow_skipped) faults = skipped_fault(source.skipped);
  const std::string heights = options.default_height_chosen ? "" : heights_fault(source);
  if (!heights.empty()) faults += (faults.empty() ? "" : "; and ") + heights;
  if (!faults.empty()) throw InputError(name, {.says = faults});
}

}  // namespace

MapDraft draft_footprints(const std::string& path, HashedStream& file,
                          const FootprintDraftOptions& asked, const Notes& notes,
                          const Execution& run) {
  if (file.head().empty()) throw InputError(path, {.says = "the file is empty"});
  const UnchangedFile same(path);  // GDAL opens both by their names
  const UnchangedFile same_terrain(asked.terrain);
  FootprintDraftOptions options = asked;
  if (!options.format) options.format = &footprint_format_of(file.head(), path);
  options.map = with_room(asked.map, *options.format);
  Source source = read(*options.format, {path, path, file.stream()}, options.read);
  MapDraft draft;
  draft.source = path;
  draft.frame = place(source, options, path);
  tell(source, path, options.read.height.default_height, notes);
  draft.facts = facts_of(source, *options.format);
  HistoryStep step = step_of(file.hash(), asked, options, source);
  same.require();
  same_terrain.require();
  refuse_at_once(source, options, path);
  settle_skipped(source.skipped, options.allow_skipped, path, notes, step);
  tell_room(asked.map, options.map, path, notes);
  draft.history = history_of(step);
  draft.options = options.map;
  draft.table = boxes_of(source.footprints, options.read.slack, run);
  draft.table.labels.resize(source.labels.size() + 1);
  for (const auto& [label, number] : source.labels) draft.table.labels[number] = label;
  return draft;
}

MapDraft draft_footprints(const std::string& path, const FootprintDraftOptions& options,
                          const Notes& notes, const Execution& run) {
  const auto in = options.open(path);
  HashedStream file(*in);
  return draft_footprints(path, file, options, notes, run);
}

}  // namespace geom::gis
