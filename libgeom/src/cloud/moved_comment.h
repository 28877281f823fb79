#pragma once

// Comments of point clouds which say that the coordinates are not whole.

#include <string_view>

#include "geom/earth/coordinate_reference.h"

namespace geom {

// Takes a comment such as "shift 500000 5000000 0", "Global shift: (-500000, -5000000, 0)" or
// "offsetx 500000" into what a file says of its coordinates. A shift of 0 and a scale of 1 say
// nothing, and so does a comment with other words than these.
class MovedComments {
 public:
  void take(std::string_view comment);
  const CoordinateReference& told() const { return told_; }

 private:
  CoordinateReference told_;
  bool of_las_ = false;  // what follows are words of a LAS header, whose numbers moved the points
};

}  // namespace geom
