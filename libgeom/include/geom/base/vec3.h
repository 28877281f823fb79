#pragma once

// The vector type of the whole toolkit.
//
// Example:
//   const geom::Vec3 way = geom::Vec3(4, 6, 3) - geom::Vec3(1, 2, 3);  // metres
//   assert(way.norm() == 5);

#include <Eigen/Core>

namespace geom {

using Vec3 = Eigen::Vector3d;  // metres, in the map's frame (frame.h)

// The largest coordinate readers accept, in metres. Beyond it a double is coarser than the
// millimetre by a good part, so a map that reaches there is in the wrong units.
inline constexpr double kLargestCoordinate = 1e8;

}  // namespace geom
