#include "plan/sampling/search_tree_file.h"

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <string>
#include <utility>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/mesh/glb.h"
#include "geom/shape/aabb.h"
#include "geom/text/json_line.h"

namespace plan {
namespace {

// Of the tree from the start and of that from the goal.
constexpr std::array<std::array<std::uint8_t, 3>, 2> kColours = {{{86, 140, 196}, {204, 102, 85}}};

bool is_root(const SearchTree& tree, std::size_t i) { return tree.parent[i] == i; }

// Positions for write_glb, and the extent that glTF demands.
struct Vertices {
  std::string bytes;
  Vec3 middle;  // in glTF's axes
  Eigen::Vector3f low = Eigen::Vector3f::Constant(3e38f);
  Eigen::Vector3f high = -low;
};

Vertices vertices(const SearchTree& tree, geom::Axes axes) {
  Vertices out;
  const geom::Aabb bounds = *geom::bounds(tree.points);
  out.middle = geom::to_gltf(geom::to_enu(axes, 0.5 * (bounds.min + bounds.max)));
  for (const Vec3& point : tree.points) {
    const Vec3 at = geom::to_gltf(geom::to_enu(axes, point)) - out.middle;
    const Eigen::Vector3f p = at.cast<float>();
    out.low = out.low.cwiseMin(p);
    out.high = out.high.cwiseMax(p);
    for (int axis = 0; axis < 3; ++axis) geom::append_bytes(out.bytes, p[axis]);
  }
  return out;
}

// The nodes at both ends of each edge of one of the trees.
std::string line_indices(const SearchTree& tree, std::size_t which) {
  std::string bytes;
  for (std::size_t i = 0; i < tree.points.size(); ++i) {
    if (tree.tree[i] != which || is_root(tree, i)) continue;
    geom::append_bytes(bytes, tree.parent[i]);
    geom::append_bytes(bytes, static_cast<std::uint32_t>(i));
  }
  return bytes;
}

}  // namespace

void write_jsonl(std::ostream& out, const SearchTree& tree, std::string_view id,
                 const geom::Provenance& provenance) {
  geom::JsonLine head;
  head.add("type", "tree").add("id", id);
  add(head, provenance);
  out << head.add("nodes", tree.points.size()).line();
  for (std::size_t i = 0; i < tree.points.size(); ++i) {
    geom::JsonLine node;
    node.add("index", i).add("parent", tree.parent[i]).add("first_parent", tree.first_parent[i]);
    node.add("tree", tree.tree[i]).add("cost", tree.cost[i]).add("point", tree.points[i]);
    out << node.line();
  }
}

void write_ply(std::ostream& out, const SearchTree& tree, geom::Axes axes) {
  const std::size_t nodes = tree.points.size();
  if (nodes > 0x7fffffff) {
    throw geom::InputError("PLY",
                           fmt::format("expected at most 2147483647 nodes, found {}", nodes));
  }
  std::string edges;
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (is_root(tree, i)) continue;
    geom::append_bytes(edges, static_cast<std::int32_t>(tree.parent[i]));
    geom::append_bytes(edges, static_cast<std::int32_t>(i));
    ++count;
  }
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment a search tree, east north up, metres\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int first_parent\n"
      "element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
      nodes, count);
  std::string bytes;
  for (std::size_t i = 0; i < nodes; ++i) {
    const Vec3 p = geom::to_enu(axes, tree.points[i]);
    for (int axis = 0; axis < 3; ++axis) geom::append_bytes(bytes, p[axis]);
    for (const std::uint8_t part : kColours[tree.tree[i]]) geom::append_bytes(bytes, part);
    geom::append_bytes(bytes, static_cast<std::int32_t>(tree.first_parent[i]));
  }
  out << bytes << edges;
}

void write_glb(std::ostream& out, const SearchTree& tree, geom::Axes axes) {
  std::string bin;
  std::string views, accessors, primitives, materials;
  Vec3 middle = Vec3::Zero();
  for (std::size_t which = 0, made = 0; which < kColours.size(); ++which) {
    const std::string indices = line_indices(tree, which);
    if (indices.empty()) continue;
    if (made == 0) {
      Vertices v = vertices(tree, axes);
      middle = v.middle;
      views = fmt::format(R"({{"buffer":0,"byteOffset":0,"byteLength":{},"target":34962}})",
                          v.bytes.size());
      accessors = fmt::format(
          R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}})",
          tree.points.size(), v.low.x(), v.low.y(), v.low.z(), v.high.x(), v.high.y(), v.high.z());
      bin = std::move(v.bytes);
    }
    views += fmt::format(R"(,{{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}})",
                         bin.size(), indices.size());
    accessors +=
        fmt::format(R"(,{{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})",
                    made + 1, indices.size() / sizeof(std::uint32_t));
    primitives +=
        fmt::format(R"({}{{"attributes":{{"POSITION":0}},"indices":{},"material":{},"mode":1}})",
                    made ? "," : "", made + 1, made);
    const auto& c = kColours[which];
    materials += fmt::format(
        R"({}{{"pbrMetallicRoughness":{{"baseColorFactor":[{:.3f},{:.3f},{:.3f},1],"metallicFactor":0}}}})",
        made ? "," : "", c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
    bin += indices;
    ++made;
  }
  std::string json = R"({"asset":{"version":"2.0","generator":"skyway"},"scene":0,"scenes":[)";
  if (bin.empty()) {
    json += "{}]}";
  } else {
    json += fmt::format(
        R"({{"nodes":[0]}}],"nodes":[{{"mesh":0,"name":"tree","translation":[{},{},{}]}}],"meshes":[{{"primitives":[{}]}}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
        middle.x(), middle.y(), middle.z(), primitives, materials, accessors, views, bin.size());
  }
  geom::write_glb_container(out, std::move(json), std::move(bin));
}

}  // namespace plan
