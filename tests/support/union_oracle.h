#pragma once

// Whether one union of closed boxes holds another, by comparisons alone: exact.

#include <vector>

#include "geom/map/box_index.h"

namespace oracle {

using geom::Aabb;

// What of `piece` is not in the union of boxes[from…] has no extent along the axes that `piece` has
// extent along. A union of closed boxes is closed, so whatever it left out would have some.
inline bool held(const Aabb& piece, const std::vector<Aabb>& boxes, std::size_t from = 0) {
  const auto meets = [&](const Aabb& box) {
    for (int i = 0; i < 3; ++i) {
      const bool flat = piece.min[i] == piece.max[i];
      if (flat ? box.min[i] > piece.min[i] || box.max[i] < piece.min[i]
               : box.min[i] >= piece.max[i] || box.max[i] <= piece.min[i]) {
        return false;
      }
    }
    return true;
  };
  while (from < boxes.size() && !meets(boxes[from])) ++from;
  if (from == boxes.size()) return false;
  Aabb rest = piece;  // what is left of it is cut off side by side
  for (int i = 0; i < 3; ++i) {
    for (const bool low : {true, false}) {
      Aabb part = rest;
      if (low ? boxes[from].min[i] <= rest.min[i] : boxes[from].max[i] >= rest.max[i]) continue;
      (low ? part.max[i] : part.min[i]) = low ? boxes[from].min[i] : boxes[from].max[i];
      if (!held(part, boxes, from + 1)) return false;
      (low ? rest.min[i] : rest.max[i]) = low ? boxes[from].min[i] : boxes[from].max[i];
    }
  }
  return true;
}

// How many boxes of `inner` are not within the union of `outer`.
inline std::size_t not_held(std::span<const Aabb> inner, std::span<const Aabb> outer) {
  geom::BoxIndex index(geom::index_cell(outer));
  for (std::size_t i = 0; i < outer.size(); ++i) index.add(i, outer[i]);
  std::size_t wrong = 0;
  for (const Aabb& box : inner) {
    std::vector<Aabb> near;
    for (const std::size_t i : index.near(box)) {
      if (geom::overlap(box, outer[i])) near.push_back(outer[i]);
    }
    wrong += !held(box, near);
  }
  return wrong;
}

}  // namespace oracle
