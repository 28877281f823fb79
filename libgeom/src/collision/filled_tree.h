#pragma once

// A tree of what a builder made, with as few nodes as its splits allow.

#include <cstddef>
#include <span>

#include "box_tree.h"

namespace geom {

// `nodes` are a tree, the root first, whose children kBox | i are boxes; all `boxes` of them once
// each, else std::logic_error. A node takes in the children of a child where they fit, the largest
// child first. Each node comes before its children, and boxes get new numbers from leaf to leaf.
BuiltTree filled_tree(const TreeFrame& frame, std::span<const BoxNode> nodes, std::size_t boxes);

}  // namespace geom
