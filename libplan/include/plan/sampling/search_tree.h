#pragma once

// What a sampling planner grew: trees of points joined by free segments.
//
// No example: sample_path() (plan/sampling/rrt.h) grows one, and search_tree_file.h writes it.

#include <cstdint>
#include <vector>

#include "geom/base/vec3.h"

namespace plan {

using geom::Vec3;

// Nodes in the order of their insertion; every member has a value a node.
struct SearchTree {
  std::vector<Vec3> points;                 // metres
  std::vector<std::uint32_t> parent;        // at the end of the search; a root is its own
  std::vector<std::uint32_t> first_parent;  // on insertion, an earlier node: for showing growth
  std::vector<double> cost;                 // metres from the root, along `parent`
  std::vector<std::uint8_t> tree;           // 0: rooted at the start, 1: at the goal

  friend bool operator==(const SearchTree&, const SearchTree&) = default;
};

}  // namespace plan
