#include "geom/map/map_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/map/derive.h"
#include "geom/map/join.h"

namespace geom {

std::set<std::uint64_t> parse_ids(std::string_view text, std::string_view source) {
  std::set<std::uint64_t> ids;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\n') ++line;
    if (std::string_view(" \t\r\n,").find(text[at]) != std::string_view::npos) {
      ++at;
      continue;
    }
    std::uint64_t id = 0;
    const auto [rest, error] = std::from_chars(text.data() + at, text.data() + text.size(), id);
    if (error != std::errc()) {
      throw InputError(
          source, line,
          {.expected = "ids (whole numbers)", .found = in_quotes(text.substr(at, 20))});
    }
    ids.insert(id);
    at = static_cast<std::size_t>(rest - text.data());
  }
  return ids;
}

std::string shared_ids(const BoxMap& map, const std::set<std::uint64_t>& ids) {
  if (map.spec().history.find("\"skyway-map join\"") == std::string::npos) return {};
  std::map<std::uint64_t, std::vector<std::size_t>> named;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (ids.contains(map.ids()[i])) named[map.ids()[i]].push_back(i);
  }
  const auto shared = std::find_if(named.begin(), named.end(),
                                   [](const auto& one) { return one.second.size() > 1; });
  if (shared == named.end()) return {};
  constexpr std::size_t kShown = 3;
  std::string where;
  for (std::size_t k = 0; k < std::min(kShown, shared->second.size()); ++k) {
    const std::size_t i = shared->second[k];
    const Vec3& corner = map.boxes()[i].min;
    where += fmt::format("{}({:g}, {:g}, {:g}) \"{}\"", k > 0 ? ", " : "", corner.x(), corner.y(),
                         corner.z(), map.labels()[map.label()[i]]);
  }
  return fmt::format(
      "the id {} names {} boxes of this joined map, which may be of different obstacles, as each "
      "map counts ids anew: {}{}",
      shared->first, shared->second.size(), where, shared->second.size() > kShown ? ", …" : "");
}

struct MapPatch::Step {
  nlohmann::ordered_json json;
};

MapPatch::MapPatch(const BoxMap& map, std::string source)
    : source_(std::move(source)),
      spec_(map.spec()),
      table_(table_of(map)),
      step_(std::make_unique<Step>(derived_step("patch", map))) {}

MapPatch::~MapPatch() = default;

std::size_t MapPatch::remove(const std::set<std::uint64_t>& ids) {
  std::set<std::uint64_t> found;
  const std::size_t before = table_.boxes.size();
  table_.keep_if([&](std::size_t i) {
    const bool named = ids.contains(table_.ids[i]);
    if (named) found.insert(table_.ids[i]);
    return !named;
  });
  for (const std::uint64_t id : ids) {
    if (!found.contains(id)) {
      throw InputError(source_,
                       {.says = fmt::format("no box has the id {} that --remove names", id)});
    }
  }
  const std::size_t removed = before - table_.boxes.size();
  step_->json["removed"] = removed;
  return removed;
}

std::size_t MapPatch::add(const char* what, BoxTable fresh) {
  std::uint64_t next = 0;
  for (const std::uint64_t id : table_.ids) next = std::max(next, id + 1);
  for (std::uint64_t& id : fresh.ids) id = next++;
  append(table_, fresh);
  step_->json[what] = fresh.boxes.size();
  return fresh.boxes.size();
}

void MapPatch::set_epoch(const std::string& epoch) {
  if (spec_.epoch && *spec_.epoch != epoch) {
    throw InputError(source_, {.expected = fmt::format("the epoch {}, as --epoch says", epoch),
                               .found = std::string(*spec_.epoch)});
  }
  spec_.epoch = epoch;
  step_->json["epoch"] = epoch;
}

void MapPatch::note(const char* what, const nlohmann::ordered_json& value) {
  step_->json[what] = value;
}

void MapPatch::note_cut_to_bounds() { note_closed_within(spec_.bounds); }

void MapPatch::note_cut_to_heights(bool below, bool above) {
  if (!below && !above) return;
  Aabb within{Vec3::Constant(-kFarthest), Vec3::Constant(kFarthest)};
  if (below) within.min.z() = spec_.bounds.min.z();
  if (above) within.max.z() = spec_.bounds.max.z();
  note_closed_within(within);
}

// A patch has one set of bounds, so those of all that it cut are the smallest of what was noted.
void MapPatch::note_closed_within(const Aabb& box) {
  closed_ = closed_ ? Aabb{closed_->min.cwiseMax(box.min), closed_->max.cwiseMin(box.max)} : box;
  const Aabb& b = *closed_;
  step_->json["closed_within"] = {b.min.x(), b.min.y(), b.min.z(), b.max.x(), b.max.y(), b.max.z()};
}

BoxMap MapPatch::made() const {
  if (table_.boxes.empty()) throw InputError(source_, {.says = "the patch leaves no boxes at all"});
  return derived(spec_, table_, step_->json);
}

}  // namespace geom
