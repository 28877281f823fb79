#pragma once

// A line in space as pictures of a map show it: a path, what a vehicle flew, an edge of a tree.
//
// Example:
//   const geom::picture::Line line = geom::picture::way_line(0, "q1", path);
//   assert(line.way && line.points.size() == path.size());

#include <string>
#include <vector>

#include "geom/picture/picture.h"
#include "geom/shape/aabb.h"

namespace geom::picture {

struct Line {
  std::vector<Vec3> points;  // ENU
  Colour colour{};
  double width = 3;  // pixels
  bool way = false;  // from a start to a goal, which are marked
  std::string id;    // of a way
};

// The `i`-th way of a picture: the colours of figures (geom/figure/palette.h) take turns.
Line way_line(std::size_t i, std::string id, std::vector<Vec3> points);

// A thin line from `a` to `b`: an edge of a search tree, of those that grew from the start (0) or
// from the goal (1).
Line tree_line(std::size_t tree, const Vec3& a, const Vec3& b);

}  // namespace geom::picture
