#include "geom/cloud/pcl_filters.h"

#include <fmt/format.h>
#include <pcl/console/print.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "geom/base/error.h"

namespace geom {
namespace {

[[noreturn]] void stop_filter() {
  throw std::runtime_error("PCL could not look at all points; memory may be short");
}

void* allocated(std::size_t bytes) {
  if (void* const out = std::malloc(bytes)) return out;
  throw std::bad_alloc();
}

}  // namespace
}  // namespace geom

// If memory is short, PCL's headers print a message and go on with fewer points, and FLANN's go on
// without a tree. These macros make both stop.
#undef PCL_ERROR
#undef PCL_WARN
#undef PCL_DEBUG
#define PCL_ERROR(...) geom::stop_filter()
#define PCL_WARN(...) geom::stop_filter()
#define PCL_DEBUG(...) static_cast<void>(0)
#define malloc(bytes) geom::allocated(bytes)
#include <flann/util/allocator.h>
#undef malloc
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/uniform_sampling.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace geom {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr shifted(const CloudPoints& points) {
  auto out = std::make_shared<Cloud>();
  out->reserve(points.size());
  for (const CloudPoint& p : points) {
    const Eigen::Vector3f f = (p.position - points.front().position).cast<float>();
    out->push_back({f.x(), f.y(), f.z()});
  }
  return out;
}

CloudPoints chosen(const CloudPoints& points, pcl::Indices indices) {
  std::sort(indices.begin(), indices.end());
  CloudPoints out;
  out.reserve(indices.size());
  for (const pcl::index_t i : indices) out.push_back(points[static_cast<std::size_t>(i)]);
  return out;
}

// Two cells more on each axis than the box needs: whatever single precision rounds stays below.
void refuse_many_voxels(const CloudPoints& points, double side, std::string_view source) {
  Vec3 low = points.front().position;
  Vec3 high = low;
  for (const CloudPoint& p : points) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
  }
  const double cells = ((high - low).array() / side + 3).prod();
  if (cells < 0x1p31) return;
  throw InputError(source, {.expected = "less than 2^31 voxels around the points",
                            .found = fmt::format("{:.3g}", cells),
                            .advice = "use a larger --voxel, or drop far points first"});
}

}  // namespace

CloudPoints without_outliers(const CloudPoints& points, int neighbours, double deviations) {
  if (points.empty()) return {};
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(shifted(points));
  filter.setMeanK(neighbours);
  filter.setStddevMulThresh(deviations);
  pcl::Indices kept;
  filter.filter(kept);
  return chosen(points, std::move(kept));
}

CloudPoints one_per_voxel(const CloudPoints& points, double side, std::string_view source) {
  if (points.empty()) return {};
  refuse_many_voxels(points, side, source);
  pcl::UniformSampling<pcl::PointXYZ> filter(true);
  filter.setInputCloud(shifted(points));
  filter.setRadiusSearch(side);
  Cloud sampled;
  filter.filter(sampled);
  // What is not removed is kept: the filter gives the points, and only these as indices.
  std::vector<bool> removed(points.size());
  for (const pcl::index_t i : *filter.getRemovedIndices())
    removed[static_cast<std::size_t>(i)] = true;
  CloudPoints out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!removed[i]) out.push_back(points[i]);
  }
  return out;
}

}  // namespace geom
