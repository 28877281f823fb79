#pragma once

// Surfaces as triangles: what models of buildings, scans and worlds are made of.

#include <array>
#include <cstdint>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

// A closed triangle between three vertices; they may coincide or lie on a line. Seen from outside
// its surface, where that has an outside, its corners go counterclockwise.
struct MeshTriangle {
  std::array<std::uint32_t, 3> corners{};  // indices of vertices
  std::uint32_t part = 0;                  // what it is a part of: an object, a label
};

struct TriangleMesh {
  std::vector<Vec3> vertices;  // metres, in the map's axes
  std::vector<MeshTriangle> triangles;
};

}  // namespace geom
