#pragma once

// Where the camera was at each frame, as CSV: what `skyway-render --poses` writes.
//
// Example:
//   std::stringstream table;
//   table << geom::picture::kPosesHeader << '\n' << geom::picture::pose_row({}, 0, 0.5);
//   assert(geom::picture::read_camera_poses(table, "table")[0].time == 0.5);

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/picture/view.h"

namespace geom::picture {

extern const std::string_view kPosesHeader;
// The quaternion turns the camera's axes (x right, y down, z forward) into ENU.
std::string pose_row(const View& view, std::size_t frame, double time);

struct CameraPose {
  double time = 0;          // s
  Vec3 eye = Vec3::Zero();  // ENU, metres
};

// A row a frame, in the order of their numbers from 0. Throws InputError(name, line, …) where
// the text is not such a table: another header, a number that is missing or not finite, a frame out
// of order, times that do not grow, or no row at all.
std::vector<CameraPose> read_camera_poses(std::istream& in, std::string_view name);

}  // namespace geom::picture
