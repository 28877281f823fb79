#include "geom/mesh/mesh.h"

#include <fmt/format.h>

#include <limits>
#include <ostream>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/mesh/gltf.h"

namespace geom {
namespace {

Aabb extent_of(std::span<const MeshPart> parts) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Aabb out{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const MeshPart& part : parts) {
    for (std::size_t i = 0; i < part.vertices; ++i) {
      const Vec3 p = part.vertex(i);
      out = merged(out, {p, p});
    }
  }
  return out;
}

void add_part(const MeshPart& part, Gltf& out) {
  if (part.triangles == 0) return;
  GltfPrimitive surface;
  surface.positions = out.add_positions(part.vertices, part.vertex);
  std::array<std::size_t, 3> corners{};
  surface.indices = out.add_indices(3 * part.triangles, [&](std::size_t i) {
    if (i % 3 == 0) corners = part.triangle(i / 3);
    return corners[i % 3];
  });
  const Rgb colour{part.colour[0] / 255.0, part.colour[1] / 255.0, part.colour[2] / 255.0};
  surface.material = out.add_material({part.name, colour, part.opacity, {}});
  out.add_node(part.name, {surface});
}

void write_ply_vertices(std::ostream& out, const MeshPart& part) {
  std::string bytes;
  for (std::size_t i = 0; i < part.vertices; ++i) {
    const Vec3 p = part.vertex(i);
    bytes.clear();
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, p[axis]);
    for (const std::uint8_t channel : part.colour) append_bytes(bytes, channel);
    out << bytes;
  }
}

void write_ply_triangles(std::ostream& out, const MeshPart& part, std::size_t first) {
  std::string bytes;
  for (std::size_t i = 0; i < part.triangles; ++i) {
    bytes.clear();
    append_bytes(bytes, std::uint8_t{3});
    for (const std::size_t k : part.triangle(i)) {
      append_bytes(bytes, static_cast<std::int32_t>(first + k));
    }
    out << bytes;
  }
}

}  // namespace

void write_ply(std::ostream& out, std::span<const MeshPart> parts) {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for (const MeshPart& part : parts) {
    vertices += part.vertices;
    triangles += part.triangles;
  }
  if (vertices > 0x7fffffff) {
    throw InputError(
        "PLY", {.expected = "at most 2147483647 vertices", .found = fmt::to_string(vertices)});
  }
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment east north up, metres\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      vertices, triangles);
  for (const MeshPart& part : parts) write_ply_vertices(out, part);
  std::size_t first = 0;
  for (const MeshPart& part : parts) {
    write_ply_triangles(out, part, first);
    first += part.vertices;
  }
}

void write_glb(std::ostream& out, std::span<const MeshPart> parts) {
  const Aabb extent = extent_of(parts);
  Gltf gltf(0.5 * (extent.min + extent.max));
  for (const MeshPart& part : parts) add_part(part, gltf);
  gltf.write(out);
}

}  // namespace geom
