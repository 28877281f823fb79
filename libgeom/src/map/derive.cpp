#include "geom/map/derive.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "geom/base/error.h"
#include "geom/map/closed_within.h"
#include "geom/map/join.h"
#include "geom/map/map_draft.h"
#include "geom/text/parse_json.h"
#include "require_bounds.h"
#include "share_outside.h"

namespace geom {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Aabb& box) {
  return {box.min[0], box.min[1], box.min[2], box.max[0], box.max[1], box.max[2]};
}

Json steps_of(const BoxMapSpec& spec, const std::string& name) {
  return parse_ordered_json(spec.history.empty() ? "[]" : spec.history, name);
}

// Seconds after different instants cannot stand in one map.
void join_epoch(BoxMapSpec& spec, const SourceMap& other) {
  const auto& epoch = other.map.spec().epoch;
  if (!epoch || spec.epoch == epoch) return;
  if (spec.epoch) {
    throw InputError(other.name,
                     {.expected = fmt::format("the epoch of the maps before, {}", *spec.epoch),
                      .found = std::string(*epoch)});
  }
  spec.epoch = epoch;
}

// Bounds move as a box does.
Aabb bounds_in(const Frame& frame, const SourceMap& other) {
  BoxMapSpec moved = other.map.spec();
  BoxTable corner;
  corner.boxes = {moved.bounds};
  corner.ids = {0};
  corner.label = {0};
  return in_frame(frame, BoxMap(std::move(moved), corner), other.name).boxes.front();
}

// Zones of a map and their like are closed within its bounds alone, and in its own frame.
void require_closed_in_join(const SourceMap& one, const BoxMapSpec& joined) {
  const auto closed = closed_within(one.map.spec());
  if (!closed) return;
  if (!(one.map.spec().frame == joined.frame)) {
    throw InputError(one.name,
                     {.says = "it has zones of airspace, fences or keep-out volumes that were cut "
                              "to its bounds, and another origin than the map that it is joined to",
                      .advice = "join the maps before you patch these into them"});
  }
  require_closed_within(one.map.spec(), joined.bounds, one.name);
}

}  // namespace

Json derived_step(const char* verb, const BoxMap& input) {
  return {{"tool", std::string("skyway-map ") + verb}, {"input", input.hash()}};
}

BoxMap derived(BoxMapSpec spec, const BoxTable& table, const Json& step) {
  Json history = steps_of(spec, "the map's history");
  history.push_back(step);
  spec.history = history.dump();
  require_within_reach(table, "the map");
  return {std::move(spec), table};
}

BoxMap crop(const BoxMap& map, const Aabb& region, const std::string& source) {
  BoxMapSpec spec = map.spec();
  spec.bounds = {spec.bounds.min.cwiseMax(region.min), spec.bounds.max.cwiseMin(region.max)};
  if ((spec.bounds.min.array() >= spec.bounds.max.array()).any()) {
    throw InputError(source, {.expected = "--bounds that meet the bounds of the map",
                              .found = "a region apart from them"});
  }
  Json step = derived_step("crop", map);
  step["bounds"] = numbers(region);
  return derived(std::move(spec), table_of(map, &region), step);
}

MadeMap with_bounds(const BoxMap& map, const BoundsChange& change, const std::string& source) {
  BoxMapSpec spec = map.spec();
  const BoxTable table = table_of(map);
  Json step = derived_step("bounds", map);
  if (change.pad && table.boxes.empty()) {
    throw InputError(source, {.expected = "obstacles to count --pad from", .found = "none"});
  }
  if (change.pad) {
    Aabb around = *bounds(table.boxes);
    around.min -= Vec3(*change.pad, *change.pad, 0);
    around.max += Vec3::Constant(*change.pad);
    spec.bounds = merged(spec.bounds, around);
    step["pad"] = *change.pad;
  }
  if (change.floor) step["floor"] = spec.bounds.min.z() = *change.floor;
  if (change.ceiling) step["ceiling"] = spec.bounds.max.z() = *change.ceiling;
  if (change.bounds) step["bounds"] = numbers(spec.bounds = *change.bounds);
  require_bounds(spec.bounds, source);
  require_closed_within(map.spec(), spec.bounds, source);
  const Aabb& before = map.spec().bounds;
  const bool within = contains(before, spec.bounds.min) && contains(before, spec.bounds.max);
  if (!within) step["widened"] = true;
  spec.bounds_from = "option";
  std::size_t beyond = 0;
  for (const Aabb& box : table.boxes) beyond += !overlap(box, spec.bounds);
  return {derived(std::move(spec), table, step), 0, beyond};
}

BoxMap join(std::span<const SourceMap> maps) {
  const BoxMap& first = maps.front().map;
  BoxMapSpec spec = first.spec();
  BoxTable table = table_of(first);
  Json step = derived_step("join", first);
  Json others = Json::array();
  Json histories = Json::array();
  std::vector<Aabb> parts = {spec.bounds};
  std::size_t skipped = 0;  // that the others know of; the first has its own history
  for (const SourceMap& other : maps.subspan(1)) {
    others.push_back(other.map.hash());
    histories.push_back(steps_of(other.map.spec(), other.name));
    skipped += skipped_in(other.map.spec());
    append(table, in_frame(spec.frame, other.map, other.name));
    join_epoch(spec, other);
    parts.push_back(bounds_in(spec.frame, other));
    spec.bounds = merged(spec.bounds, parts.back());
  }
  for (const SourceMap& one : maps) require_closed_in_join(one, spec);
  step["others"] = others;
  step["histories"] = histories;
  if (skipped > 0) step["skipped"] = skipped;
  if (const double gap = share_outside(parts); gap > 0) step["joined_gap"] = gap;
  return derived(std::move(spec), table, step);
}

bool heights_unknown(std::span<const SourceMap> maps) {
  const Frame& first = maps.front().map.spec().frame;
  return std::any_of(maps.begin(), maps.end(), [&](const SourceMap& one) {
    const Frame& frame = one.map.spec().frame;
    return !(frame == first) && frame.origin && frame.origin->height == 0;
  });
}

BoxMap inflate(const BoxMap& map, double by) {
  BoxTable table = table_of(map);
  for (Aabb& box : table.boxes) box = grow(box, Vec3::Constant(by));
  Json step = derived_step("inflate", map);
  step["by"] = by;
  return derived(map.spec(), table, step);
}

BoxMap tile(const BoxMap& map, double size) {
  BoxMapSpec spec = map.spec();
  spec.tile_size = size;
  Json step = derived_step("tile", map);
  step["size"] = size;
  return derived(std::move(spec), table_of(map), step);
}

BoxMap derived(const BoxMap& map, const Merged& merged) {
  return derived(map.spec(), merged.table, derived_step("merge", map));
}

BoxMap derived(const BoxMap& map, const Simplified& simple, double slack) {
  Json step = derived_step("simplify", map);
  step["slack"] = slack;
  return derived(map.spec(), simple.table, step);
}

}  // namespace geom
