#include "geom/mesh/mesh.h"

#include <fmt/format.h>

#include <limits>
#include <ostream>
#include <utility>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/mesh/glb.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

constexpr std::size_t kMostBytes = 0xf0000000u;  // of a .glb, which counts them in 32 bits

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
};

Extent extent_of(std::span<const MeshPart> parts) {
  Extent out;
  for (const MeshPart& part : parts) {
    for (std::size_t i = 0; i < part.vertices; ++i) {
      const Vec3 p = part.vertex(i);
      out.low = out.low.cwiseMin(p);
      out.high = out.high.cwiseMax(p);
    }
  }
  return out;
}

// The lists of the JSON chunk, and the binary one, as part after part is added.
struct GltfLists {
  Vec3 middle;
  std::string bin;
  std::string nodes, meshes, materials, accessors, views;
  std::size_t made = 0;

  void add(const MeshPart& part);
  std::string json() const;

 private:
  void add_buffers(const MeshPart& part);
};

void GltfLists::add_buffers(const MeshPart& part) {
  const std::string comma = made ? "," : "";
  const std::size_t bytes = 12 * (part.vertices + part.triangles);
  if (bin.size() + bytes > kMostBytes || part.vertices > 0xffffffffu) {
    throw InputError("glTF", "the mesh takes more than the 4 GB of a .glb: crop the map");
  }
  Eigen::Vector3f low = Eigen::Vector3f::Constant(3e38f);
  Eigen::Vector3f high = -low;
  const std::size_t positions = bin.size();
  for (std::size_t i = 0; i < part.vertices; ++i) {
    const Eigen::Vector3f p = to_gltf(part.vertex(i) - middle).cast<float>();
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (int axis = 0; axis < 3; ++axis) append_bytes(bin, p[axis]);
  }
  const std::size_t indices = bin.size();
  for (std::size_t i = 0; i < part.triangles; ++i) {
    for (const std::size_t k : part.triangle(i)) append_bytes(bin, static_cast<std::uint32_t>(k));
  }
  views +=
      comma +
      fmt::format(
          R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34962}},{{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}})",
          positions, indices - positions, indices, bin.size() - indices);
  accessors +=
      comma +
      fmt::format(
          R"({{"bufferView":{},"componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}},{{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})",
          2 * made, part.vertices, low.x(), low.y(), low.z(), high.x(), high.y(), high.z(),
          2 * made + 1, 3 * part.triangles);
}

void GltfLists::add(const MeshPart& part) {
  if (part.triangles == 0) return;
  add_buffers(part);
  const std::string comma = made ? "," : "";
  const Vec3 at = to_gltf(middle);
  const std::string name = json_text(part.name);
  nodes += comma + fmt::format(R"({{"mesh":{},"name":{},"translation":[{},{},{}]}})", made, name,
                               at.x(), at.y(), at.z());
  meshes +=
      comma +
      fmt::format(
          R"({{"name":{},"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{},"material":{}}}]}})",
          name, 2 * made, 2 * made + 1, made);
  materials +=
      comma +
      fmt::format(
          R"({{"name":{},"pbrMetallicRoughness":{{"baseColorFactor":[{:.3f},{:.3f},{:.3f},{}],"metallicFactor":0}}{}}})",
          name, part.colour[0] / 255.0, part.colour[1] / 255.0, part.colour[2] / 255.0,
          part.opacity, part.opacity < 1 ? R"(,"alphaMode":"BLEND","doubleSided":true)" : "");
  ++made;
}

std::string GltfLists::json() const {
  constexpr std::string_view kAsset =
      R"({"asset":{"version":"2.0","generator":"skyway"},"scene":0,)";
  if (made == 0) return std::string(kAsset) + R"("scenes":[{}]})";
  std::string scene;
  for (std::size_t i = 0; i < made; ++i) scene += fmt::format("{}{}", i ? "," : "", i);
  return std::string(kAsset) +
         fmt::format(
             R"("scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
             scene, nodes, meshes, materials, accessors, views, bin.size());
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
    throw InputError("PLY",
                     fmt::format("expected at most 2147483647 vertices, found {}", vertices));
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
  GltfLists lists;
  const Extent extent = extent_of(parts);
  lists.middle = 0.5 * (extent.low + extent.high);
  for (const MeshPart& part : parts) lists.add(part);
  std::string json = lists.json();
  write_glb_container(out, std::move(json), std::move(lists.bin));
}

}  // namespace geom
