#pragma once

// Boxes, paths and trees as triangles, for viewers: PLY and glTF.
//
// Example:
//   std::ofstream out("city.ply", std::ios::binary);
//   geom::write_ply(out, geom::box_parts(map));
//   assert(geom::box_parts(map)[0].triangles == 12 * map.size());

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/shape/polytope.h"

namespace geom {

// A surface of one colour, in east-north-up axes and metres. Vertices and triangles (facing
// outward) are asked for one by one while writing, so that large maps need no copy.
struct MeshPart {
  std::string name;
  std::array<std::uint8_t, 3> colour{};
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::function<Vec3(std::size_t)> vertex;
  std::function<std::array<std::size_t, 3>(std::size_t)> triangle;  // indices of vertices
  double opacity = 1;  // in glTF; below 1 what is behind shines through
};

// A part a label, 8 vertices and 12 triangles a box. `map` must outlive them.
std::vector<MeshPart> box_parts(const BoxMap& map);

// A sphere of 66 vertices and 128 triangles at each point, and a cylinder of 8 sides, open at its
// ends, along each edge (indices of points).
struct Rods {
  std::string name;
  std::array<std::uint8_t, 3> colour{};
  std::vector<Vec3> points;  // ENU
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  double radius = 0.25;        // of the cylinders, metres
  double sphere_radius = 0.5;  // metres
};
MeshPart rod_part(Rods rods);

// Convex regions, as geom/shape/polytope.h gives them: each face a fan of triangles. `axes` are
// those of the vertices.
MeshPart polytope_part(std::string name, std::array<std::uint8_t, 3> colour, Axes axes,
                       std::span<const Polytope> regions);

// Binary little-endian PLY: vertices (double) with the colour of their part, and triangles. Throws
// InputError for more than 2^31 - 1 vertices.
void write_ply(std::ostream& out, std::span<const MeshPart> parts);

// Binary glTF 2.0 (`.glb`): a node, mesh and material a part, single precision relative to the
// middle of all (the nodes' translation), y up as glTF wants: x east, z south. Parts without
// triangles are left out. Throws InputError beyond the format's 4 GB.
void write_glb(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace geom
