#pragma once

// Filters of point clouds: outliers left out, one point for each voxel.
//
// Example:
//   const geom::CloudPoints points = {{{0, 0, 0}}, {{0.1, 0, 0}}, {{5, 0, 0}}};
//   assert(geom::one_per_voxel(points, 1, "scan.xyz").size() == 2);
//
// They are PCL's. All work in single precision relative to the first point, and give indices, so
// that the points themselves lose nothing.

#include <string_view>
#include <vector>

#include "geom/cloud/point_cloud.h"

namespace geom {

using CloudPoints = std::vector<CloudPoint>;

// CloudPoints whose mean distance to their `neighbours` nearest is within `deviations` standard
// deviations of the mean of all (pcl::StatisticalOutlierRemoval).
CloudPoints without_outliers(const CloudPoints& points, int neighbours, double deviations);

// One point of each cubic cell of that side, the one nearest to its middle (pcl::UniformSampling).
// Throws InputError(source, …) where the box around the points has 2^31 cells or more: PCL's index
// of cells would wrap, and points far apart count as one.
CloudPoints one_per_voxel(const CloudPoints& points, double side, std::string_view source);

}  // namespace geom
