#pragma once

// Search trees as triangles, to be shown beside the boxes of a map.
//
// Example:
//   plan::SearchTreeRecord record{.id = "q1"};
//   record.tree = {.points = {{1, 1, 1}, {2, 1, 1}}, .parent = {0, 0}, .tree = {0, 0}};
//   const auto parts = plan::tree_parts(record, map.spec().frame.axes, 0.3);
//   assert(parts.size() == 1 && parts[0].name == "tree q1 from the start");

#include <vector>

#include "geom/mesh/mesh.h"
#include "plan/sampling/search_tree_file.h"

namespace plan {

// A part for the tree from the start and one for that from the goal, as far as they have nodes:
// spheres twice as thick as the cylinders of the edges between them, whose radius is in metres.
// `axes` are those of the record.
std::vector<geom::MeshPart> tree_parts(const SearchTreeRecord& record, geom::Axes axes,
                                       double radius);

}  // namespace plan
