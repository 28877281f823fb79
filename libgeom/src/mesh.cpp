#include "geom/io/mesh.h"

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <utility>

#include "geom/error.h"
#include "geom/io/bytes.h"
#include "geom/io/glb.h"
#include "geom/io/record.h"
#include "geom/label_colour.h"

namespace geom {
namespace {

// Corner i has the upper x where bit 0 is set, y for bit 1, z for bit 2; counter-clockwise from
// outside in right-handed axes.
constexpr std::array<std::array<std::uint32_t, 3>, 12> kTriangles = {{{0, 2, 1},
                                                                      {1, 2, 3},
                                                                      {4, 5, 6},
                                                                      {5, 7, 6},
                                                                      {0, 1, 4},
                                                                      {1, 5, 4},
                                                                      {2, 6, 3},
                                                                      {3, 6, 7},
                                                                      {0, 4, 2},
                                                                      {2, 4, 6},
                                                                      {1, 3, 5},
                                                                      {3, 7, 5}}};

Vec3 corner(const Aabb& box, unsigned i) {
  return {i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
          i & 4 ? box.max.z() : box.min.z()};
}

Aabb in_enu(Axes axes, const Aabb& box) { return {to_enu(axes, box.min), to_enu(axes, box.max)}; }

}  // namespace

void write_ply(std::ostream& out, const BoxMap& map) {
  const auto boxes = map.boxes();
  if (8 * boxes.size() > 0x7fffffff) {
    throw InputError("PLY",
                     fmt::format("expected at most 268435455 boxes, found {}", boxes.size()));
  }
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment boxes of a map, east north up, metres\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      8 * boxes.size(), 12 * boxes.size());
  std::string bytes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb box = in_enu(map.spec().frame.axes, boxes[i]);
    bytes.clear();
    for (unsigned k = 0; k < 8; ++k) {
      const Vec3 p = corner(box, k);
      for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, p[axis]);
      for (const std::uint8_t part : label_colour(map.label()[i])) append_bytes(bytes, part);
    }
    out << bytes;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bytes.clear();
    for (const auto& triangle : kTriangles) {
      append_bytes(bytes, std::uint8_t{3});
      for (const std::uint32_t k : triangle)
        append_bytes(bytes, static_cast<std::int32_t>(8 * i + k));
    }
    out << bytes;
  }
}

void write_glb(std::ostream& out, const BoxMap& map) {
  const auto boxes = map.boxes();
  const Axes axes = map.spec().frame.axes;
  const Aabb bounds = in_enu(axes, map.spec().bounds);
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  std::string bin;
  std::string nodes, meshes, materials, accessors, views;
  std::size_t made = 0;
  for (std::uint32_t label = 0; label < map.labels().size(); ++label) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (map.label()[i] == label) members.push_back(i);
    }
    if (members.empty()) continue;
    const std::size_t positions = bin.size();
    Eigen::Vector3f low = Eigen::Vector3f::Constant(3e38f);
    Eigen::Vector3f high = -low;
    for (const std::size_t i : members) {
      const Aabb box = in_enu(axes, boxes[i]);
      for (unsigned k = 0; k < 8; ++k) {
        const Eigen::Vector3f p = to_gltf(corner(box, k) - middle).cast<float>();
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        for (int axis = 0; axis < 3; ++axis) append_bytes(bin, p[axis]);
      }
    }
    const std::size_t indices = bin.size();
    for (std::size_t n = 0; n < members.size(); ++n) {
      for (const auto& triangle : kTriangles) {
        for (const std::uint32_t k : triangle)
          append_bytes(bin, static_cast<std::uint32_t>(8 * n + k));
      }
    }
    if (bin.size() > 0xf0000000u) {
      throw InputError("glTF", "the boxes take more than the 4 GB of a .glb: crop the map");
    }
    const Vec3 at = to_gltf(middle);
    const std::string comma = made ? "," : "";
    std::string text;
    append_json(text,
                std::string_view(map.labels()[label].empty() ? "boxes" : map.labels()[label]));
    nodes += comma + fmt::format(R"({{"mesh":{},"name":{},"translation":[{},{},{}]}})", made, text,
                                 at.x(), at.y(), at.z());
    meshes +=
        comma +
        fmt::format(
            R"({{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{},"material":{}}}]}})",
            2 * made, 2 * made + 1, made);
    const auto c = label_colour(label);
    materials +=
        comma +
        fmt::format(
            R"({{"pbrMetallicRoughness":{{"baseColorFactor":[{:.3f},{:.3f},{:.3f},1],"metallicFactor":0}}}})",
            c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
    views +=
        comma +
        fmt::format(
            R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34962}},{{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}})",
            positions, indices - positions, indices, bin.size() - indices);
    accessors +=
        comma +
        fmt::format(
            R"({{"bufferView":{},"componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}},{{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})",
            2 * made, 8 * members.size(), low.x(), low.y(), low.z(), high.x(), high.y(), high.z(),
            2 * made + 1, 36 * members.size());
    ++made;
  }
  std::string scene;
  for (std::size_t i = 0; i < made; ++i) scene += fmt::format("{}{}", i ? "," : "", i);
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"skyway"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      scene, nodes, meshes, materials, accessors, views, bin.size());
  write_glb_container(out, std::move(json), std::move(bin));
}

}  // namespace geom
