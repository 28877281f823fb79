#pragma once

// From a table of boxes to a map: bounds, floor and sealing.

#include <optional>

#include "geom/box_map.h"

namespace geom {

struct MakeMapOptions {
  std::optional<Aabb> source_bounds;  // bounds that the source itself gives: kept
  std::optional<Aabb> bounds;         // asked for: replaces all others
  std::optional<double> floor;        // lower z of the bounds, metres
  std::optional<double> ceiling;      // upper z
  double pad = 0;   // metres around the bounding box of the obstacles, sideways and upward
  double seal = 0;  // obstacles that hang less than this above the floor are let down to it
  double tile_size = 100;
};

struct MadeMap {
  BoxMap map;
  std::size_t sealed = 0;  // obstacles let down to the floor
  std::size_t beyond = 0;  // obstacles wholly outside the bounds (kept)
};

// `table` has at least one box. Throws InputError(source, …) when the bounds are empty.
MadeMap make_map(BoxTable table, Frame frame, std::string history, std::string_view source,
                 const MakeMapOptions& options);

}  // namespace geom
