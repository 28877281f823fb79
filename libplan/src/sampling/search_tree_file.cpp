#include "plan/sampling/search_tree_file.h"

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/mesh/gltf.h"
#include "geom/shape/aabb.h"
#include "geom/text/json_line.h"

namespace plan {
namespace {

// Of the tree from the start and of that from the goal.
constexpr std::array<std::array<std::uint8_t, 3>, 2> kColours = {{{86, 140, 196}, {204, 102, 85}}};

bool is_root(const SearchTree& tree, std::size_t i) { return tree.parent[i] == i; }

// The nodes at both ends of each edge of one of the trees.
std::vector<std::uint32_t> ends_of_edges(const SearchTree& tree, std::size_t which) {
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0; i < tree.points.size(); ++i) {
    if (tree.tree[i] != which || is_root(tree, i)) continue;
    ends.push_back(tree.parent[i]);
    ends.push_back(static_cast<std::uint32_t>(i));
  }
  return ends;
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
    throw geom::InputError(
        "PLY", {.expected = "at most 2147483647 nodes", .found = fmt::to_string(nodes)});
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
  const geom::Aabb extent =
      geom::bounds(tree.points).value_or(geom::Aabb{geom::Vec3::Zero(), geom::Vec3::Zero()});
  geom::Gltf gltf(geom::to_enu(axes, 0.5 * (extent.min + extent.max)));
  std::vector<geom::GltfPrimitive> lines;
  for (std::size_t which = 0; which < kColours.size(); ++which) {
    const std::vector<std::uint32_t> ends = ends_of_edges(tree, which);
    if (ends.empty()) continue;
    const std::size_t positions =  // both trees draw between the same points
        lines.empty()
            ? gltf.add_positions(tree.points.size(),
                                 [&](std::size_t i) { return geom::to_enu(axes, tree.points[i]); })
            : lines.front().positions;
    const auto& c = kColours[which];
    const geom::Rgb colour{c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
    lines.push_back({geom::GltfMode::lines, positions,
                     gltf.add_indices(ends.size(), [&](std::size_t i) { return ends[i]; }),
                     gltf.add_material({{}, colour, 1, {}})});
  }
  if (!lines.empty()) gltf.add_node("tree", std::move(lines));
  gltf.write(out);
}

}  // namespace plan
