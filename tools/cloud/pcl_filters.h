#pragma once

// What PCL does to clouds. All work in single precision relative to the first point, and give
// indices, so that the points themselves lose nothing.

#include <cstddef>
#include <vector>

#include "geom/io/point_cloud.h"

namespace cloud {

using Points = std::vector<geom::CloudPoint>;

// Points whose mean distance to their `neighbours` nearest is within `deviations` standard
// deviations of the mean of all (pcl::StatisticalOutlierRemoval).
Points without_outliers(const Points& points, int neighbours, double deviations);

// One point of each cubic cell of that side, the one nearest to its middle (pcl::UniformSampling).
Points one_per_voxel(const Points& points, double side);

// Groups of points that are linked by steps of at most `tolerance` metres, largest first
// (pcl::EuclideanClusterExtraction).
std::vector<std::vector<std::size_t>> clusters(const Points& points, double tolerance);

}  // namespace cloud
