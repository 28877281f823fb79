#pragma once

// From a table of boxes to a map: units, growth, bounds, floor and sealing.
//
// Example:
//   geom::BoxTable table;
//   table.add({{0, 0, 0}, {10, 10, 8}}, 1);
//   const geom::MadeMap made = geom::make_map(table, geom::Frame{}, "[]", "boxes.csv",
//                                             {.ceiling = 50, .pad = 20});
//   assert(made.map.spec().bounds.max == geom::Vec3(30, 30, 50));

#include <optional>

#include "geom/map/box_map.h"

namespace geom {

// In this order: the source's numbers times `scale`; boxes bloated, then inflated (the vehicle's
// growth comes later, by CollisionScene, and is another matter); bounds; sealing.
struct MakeMapOptions {
  double scale = 1;          // metres per unit of the source, > 0
  double bloat_percent = 0;  // each box grows about its centre by this share of its own size
  double inflate = 0;        // metres that each face moves outward, rounded outward (geom::grow)
  std::optional<Aabb> source_bounds;  // bounds that the source itself gives: kept
  std::optional<Aabb> bounds;         // asked for: replaces all others
  std::optional<double> floor;        // lower z of the bounds, metres
  std::optional<double> ceiling;      // upper z
  // Metres around the bounding box of the obstacles, sideways and upward; absent: 0.
  std::optional<double> pad;
  // Metres above the highest obstacle, in place of `pad`: for sources that tell where obstacles
  // end.
  std::optional<double> headroom;
  // Obstacles that hang less than this above the floor, in metres, are let down to it. Unless said:
  // what the source's format asks for (ImportedBoxes), and else 0.
  std::optional<double> seal;
  double tile_size = 100;
};

struct MadeMap {
  BoxMap map;
  std::size_t sealed = 0;  // obstacles let down to the floor
  std::size_t beyond = 0;  // obstacles wholly outside the bounds (kept)
};

// `table` has at least one box. Throws InputError(source, …) when the bounds are empty or not
// finite, when scale or growth take a box beyond kLargestCoordinate, and when all boxes are more
// than 200 km from an origin on Earth that they should count from.
MadeMap make_map(BoxTable table, Frame frame, std::string history, std::string_view source,
                 const MakeMapOptions& options, const Execution& run = {});

}  // namespace geom
