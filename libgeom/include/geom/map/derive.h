#pragma once

// Maps made of other maps. The history of each says so in one more step.
//
// Example:
//   const geom::BoxMap part = geom::crop(map, {{0, 0, 0}, {6, 6, 10}}, "city.boxmap");
//   const geom::BoxMap grown = geom::inflate(part, 0.5);
//   assert(grown.box(0).min.x() <= 3.5);

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "geom/map/box_map.h"
#include "geom/map/make_map.h"
#include "geom/map/merge.h"
#include "geom/map/simplify.h"

namespace geom {

// A map and what messages call it.
struct SourceMap {
  std::string name;
  BoxMap map;
};

// A step of a history: "crop" of this map.
nlohmann::ordered_json derived_step(const char* verb, const BoxMap& input);

// Of this table; `step` comes after those of the spec's history. Throws InputError for a box beyond
// 1e8 m, as all functions below do.
BoxMap derived(BoxMapSpec spec, const BoxTable& table, const nlohmann::ordered_json& step);

// The boxes that meet the region, and the bounds inside it. Throws InputError(source, …) where the
// region does not meet the bounds.
BoxMap crop(const BoxMap& map, const Aabb& region, const std::string& source);

// Bounds to set: `bounds` in place of all others, or the map's own, changed.
struct BoundsChange {
  std::optional<Aabb> bounds;
  std::optional<double> floor;    // lower z, metres
  std::optional<double> ceiling;  // upper z
  std::optional<double> pad;      // reach at least so far beyond the obstacles, sideways and upward
};

// The same boxes within other bounds, which the map then has from an option. `beyond` counts the
// boxes wholly outside of them; all are kept. Throws InputError(source, …) where the bounds are
// empty or not finite.
MadeMap with_bounds(const BoxMap& map, const BoundsChange& change, const std::string& source);

// All boxes of the maps, at least one, in the frame of the first; the bounds are around all bounds.
// The history says how much of them lies within the bounds of no map (map_doubts.h). Throws
// InputError as in_frame() does, and where two have different epochs.
BoxMap join(std::span<const SourceMap> maps);

// Whether these are maps of different origins whose heights nobody knows, so that their z can only
// be taken as it is.
bool heights_unknown(std::span<const SourceMap> maps);

// Each box grown by so many metres on every side, rounded outward.
BoxMap inflate(const BoxMap& map, double by);

// The same in tiles of another size, metres.
BoxMap tile(const BoxMap& map, double size);

// Of merge() and simplify() (merge.h, simplify.h).
BoxMap derived(const BoxMap& map, const Merged& merged);
BoxMap derived(const BoxMap& map, const Simplified& simple, double slack);

}  // namespace geom
