#pragma once

// Vertices and faces of the region behind planes.
//
// Example:
//   const std::vector<geom::Plane> cube = {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1},
//                                          {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{0, 0, -1}, 1}};
//   const geom::Polytope shape = geom::polytope(cube);
//   assert(shape.vertices.size() == 8 && shape.faces.size() == 6);

#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/separation.h"

namespace geom {

struct Polytope {
  std::vector<Vec3> vertices;                     // metres, rounded once from the exact points
  std::vector<std::vector<std::uint32_t>> faces;  // of each plane that has one: its vertices in
                                                  // turn, counterclockwise seen from outside
};

// The closed region where normal.dot(x) <= offset for every plane (coefficients taken as they
// stand). Vertices are where three planes meet behind all others, decided by CGAL's exact kernel,
// so planes may meet in fours or coincide. The region must be bounded; empty, or flat, it has no
// faces. O(n^4) for n planes: for drawing, tens of planes.
Polytope polytope(std::span<const Plane> planes);

}  // namespace geom
