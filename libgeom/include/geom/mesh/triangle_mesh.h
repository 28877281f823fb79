#pragma once

// Surfaces as triangles: what models of buildings, scans and worlds are made of.
//
// Example:
//   geom::TriangleMesh mesh;
//   mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
//   mesh.triangles.push_back({.corners = {0, 1, 2}, .part = 0});

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
