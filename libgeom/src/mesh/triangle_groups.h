#pragma once

// Which triangles make one surface, and whether it is closed.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/mesh/triangle_mesh.h"

namespace geom {

struct TriangleGroup {
  std::size_t first = 0;  // of TriangleGroups::triangles
  std::size_t count = 0;
  std::uint32_t part = 0;
  bool closed = false;
};

struct TriangleGroups {
  std::vector<std::uint32_t> triangles;  // by group, in a group ascending
  std::vector<TriangleGroup> groups;     // by their first triangle
  std::size_t open_surfaces = 0;
};

// A group for each part.
TriangleGroups groups_by_part(const TriangleMesh& mesh);

// A group for each closed surface, and one for all that is left of a part. A surface is what is
// connected by edges within a part, vertices of equal coordinates being one; it is closed where
// each edge is gone along as often in either direction, and at least four triangles make it.
// Indices must be those of vertices.
TriangleGroups groups_by_surface(const TriangleMesh& mesh);

}  // namespace geom
