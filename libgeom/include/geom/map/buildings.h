#pragma once

// Which boxes of a map make up one building, for pictures.
//
// Example:
//   const std::vector<geom::Aabb> boxes = {
//       {{0, 0, 0}, {1, 1, 9}}, {{1, 0, 0}, {2, 1, 9}}, {{8, 0, 0}, {9, 1, 9}}};
//   assert(geom::buildings_of({.boxes = boxes}).count == 2);

#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

// What the boxes are known by. Ids and labels are as many as boxes, or none.
struct BuildingParts {
  std::span<const Aabb> boxes;  // metres, east, north, up
  std::span<const std::uint64_t> ids = {};
  std::span<const std::uint32_t> labels = {};  // 0: no label
};

struct Buildings {
  std::vector<std::uint32_t> of;  // of each box the number of its building
  std::vector<std::uint8_t>
      covered;  // of each box which walls stand inside: 1 west, 2 east, 4 south, 8 north
  std::size_t count = 0;
  double typical = 1;  // metres across, of the middle one in order of size; 1 without a building
};

// Boxes that touch (5 mm) and share an id are one building; where no two such boxes touch, those
// that share a label; and where no two of these touch, those whose tops are level (1 cm). Buildings
// are numbered from 0 in order of their first boxes. A wall stands inside where one box of the
// building covers it. Not for collision checking.
Buildings buildings_of(const BuildingParts& parts);

}  // namespace geom
