#pragma once

// Boxes that cover triangles, and what closed surfaces enclose.
//
// Example:
//   const geom::TriangleMesh slope{.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 4}},
//                                  .triangles = {{.corners = {0, 1, 2}}}};
//   geom::TriangleCoverOptions options;
//   options.slack = 0.25;  // metres that boxes may reach outside
//   const geom::TriangleCover cover = geom::cover_triangles(slope, options);
//   geom::BoxTable table;
//   for (const geom::Aabb& box : cover.boxes) table.add(box, 1);

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/base/execution.h"
#include "geom/mesh/triangle_mesh.h"
#include "geom/shape/aabb.h"

namespace geom {

// What is solid besides the triangles.
enum class SolidFill : std::uint8_t {
  none,    // nothing: the shell
  inside,  // what closed surfaces enclose
  down_to  // all between the triangles of a part and a height
};

struct TriangleCoverOptions {
  double slack = 0.5;  // metres, > 0: how far boxes may reach outside triangles and solid
  SolidFill fill = SolidFill::none;
  std::vector<double> down_to;  // a height for each part, for SolidFill::down_to alone
  double most_pieces = 3e8;     // refused beyond: see below
};

struct TriangleCover {
  std::vector<Aabb> boxes;
  std::vector<std::uint32_t> part;  // of each box: the part whose triangles it covers
  std::size_t closed = 0;           // with SolidFill::inside: surfaces that were filled,
  std::size_t open = 0;             // and connected surfaces that are a shell only
};

// Boxes that contain every point of the closed triangles and of what is solid besides, in real
// arithmetic, and none of which reaches further than the slack (Euclidean) outside both. Boxes do
// not reach outside the bounding box of their part either (with `inside`: of their surface), so a
// cuboid that is filled is one box, its own.
//
// With `inside`, surfaces are what is connected by edges, in one part; vertices of equal
// coordinates are one. A surface is closed where each edge is gone along as often in one direction
// as in the other, as where two triangles share it that face the same way. Inside is what it winds
// around, however often and whichever way it faces; a hollow that another surface encloses is
// filled too. With `down_to`, the solid is between each triangle and the height of its part.
//
// Columns: the plane is cut into square cells of 0.625 of the slack. Each triangle is cut by the
// rows of cells (Sutherland and Hodgman, "Reentrant polygon clipping", 1974), and its heights over
// runs of cells are rounded outward by more than all rounding of the cutting. In a run, heights
// differ from those of each cell by at most 0.46 of the slack; runs become boxes of rows that
// repeat them. No surface lies between the heights in a cell, so one exact winding number tells
// whether all of that is inside.
//
// The same boxes for any number of threads. Cost: the pieces, which are the runs of cells of all
// triangles; memory: the triangles, and the boxes. Throws InputError("triangles", …) where an index
// has no vertex or a part no height, where a coordinate is not finite or beyond kLargestCoordinate,
// where the slack is below 1e-6 m or 1e-9 of the largest coordinate, and, before any is cut, where
// there would be more than `most_pieces`; it then names the slack that would do.
TriangleCover cover_triangles(const TriangleMesh& mesh, const TriangleCoverOptions& options,
                              const Execution& run = {});

}  // namespace geom
