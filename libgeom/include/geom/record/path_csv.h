#pragma once

// Paths as a table of points.
//
// Example:
//   std::istringstream in("id,x,y,z\na,0,0,5\na,10,0,5\nb,0,0,9\n");
//   const std::vector<geom::PathRecord> paths = geom::read_path_csv(in, "paths.csv");
//   assert(paths.size() == 2 && paths[0].points.size() == 2);

#include <iosfwd>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/record/record.h"

namespace geom {

// A point a row in the map's `axes`, metres, or in those that a comment names ("# frame: ned",
// axes_comment.h), which become the map's: columns id,x,y,z, or x,y,z for one path of the id
// "path". A header naming them is optional, and its names may end in _m. Rows of an id stand
// together. Comments may come first; one may be that header. The records are found paths without
// provenance. Throws InputError(source, line, …) for other columns, a coordinate that is no finite
// number within 1e8 m, an id that comes again later, an empty table, several paths that all have
// one point (the first column may count rows, or be a time), ids such as 0.5 without a header (they
// may be times or coordinates), a comment that names other columns, another unit or axes that
// are not ENU, NEU or NED, and a last line
// without its end, which may have lost digits.
std::vector<PathRecord> read_path_csv(std::istream& in, std::string_view source,
                                      Axes axes = Axes::enu);

}  // namespace geom
