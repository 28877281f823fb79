#pragma once

// Search trees as files for viewers: JSON Lines, PLY and glTF.
//
// Example:
//   const plan::SearchTree tree = plan::sample_path(scene, {1, 1, 1}, {9, 1, 1},
//                                                   plan::SamplingMethod::rrt).tree;
//   std::ostringstream out;
//   plan::write_jsonl(out, tree, "q1", geom::provenance_of(scene));
//   plan::write_ply(out, tree, geom::Axes::enu);
//
// The nodes stand in the order of their insertion. All take an empty tree.

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "geom/map/frame.h"
#include "geom/record/record.h"
#include "plan/sampling/search_tree.h"

namespace plan {

// JSON Lines, in the map's frame: `{"type":"tree","id":…,"map":…,…,"nodes":N}`, then a line a node,
// `{"index":0,"parent":0,"first_parent":0,"tree":0,"cost":0,"point":[x,y,z]}`.
void write_jsonl(std::ostream& out, const SearchTree& tree, std::string_view id,
                 const geom::Provenance& provenance);

// Binary little-endian PLY: a vertex a node (double, in east-north-up axes, with a colour a tree
// and `first_parent`), an edge a node that is no root, from its parent to it. `axes` are the map's.
// Throws geom::InputError for more than 2^31 - 1 nodes.
void write_ply(std::ostream& out, const SearchTree& tree, geom::Axes axes);

// Binary glTF 2.0 (`.glb`): a mesh of lines from parents to nodes, a primitive and colour a tree,
// in single precision relative to the middle of the nodes (the glTF node's translation), y up as
// glTF wants: x east, z south. A tree without edges is an empty scene.
void write_glb(std::ostream& out, const SearchTree& tree, geom::Axes axes);

struct SearchTreeRecord {
  std::string id;
  geom::Provenance provenance;
  SearchTree tree;
};

// Reads what write_jsonl wrote, line by line: a stream may hold several trees. All throw
// InputError(source, line, …) for what is not such a record: a node out of order, a parent that is
// not there, a first_parent that is no earlier node.
class SearchTreeReader {
 public:
  SearchTreeReader(std::string_view header, std::string_view source, std::size_t line);

  bool complete() const { return record_.tree.points.size() == nodes_; }
  void add(std::string_view node, std::string_view source, std::size_t line);

  // The tree once complete; refuses, as of that line, where nodes are missing.
  SearchTreeRecord finish(std::string_view source, std::size_t line) &&;

 private:
  SearchTreeRecord record_;
  std::size_t nodes_ = 0;
};

}  // namespace plan
