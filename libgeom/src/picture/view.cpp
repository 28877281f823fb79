#include "geom/picture/view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace geom::picture {
namespace {

constexpr double kFill = 0.94;  // of the picture, by what is shown

void put_middle_at_centre(View& view) {
  view.cx = 0.5 * (view.width - 1);
  view.cy = 0.5 * (view.height - 1);
}

Vec3 corner(const Aabb& box, int i) {
  return {i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
          i & 4 ? box.max.z() : box.min.z()};
}

// Moves the eye so that the corners of the region fill the picture, all of them inside.
void fit(const Aabb& region, View& view) {
  view.eye =
      0.5 * (region.min + region.max) - view.axes.col(2) * (region.max - region.min).norm() * 2;
  for (int round = 0; round < 12; ++round) {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = -low;
    for (int i = 0; i < 8; ++i) {
      const Vec3 at = project(view, corner(region, i));
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    // Sideways to the middle, then nearer or further by how much it fills.
    const double depth = low.z();
    const Vec3 off = 0.5 * (low + high) - Vec3(view.cx, view.cy, 0);
    view.eye += depth / view.fx * (off.x() * view.axes.col(0) + off.y() * view.axes.col(1));
    const double fills = std::max((high.x() - low.x()) / (kFill * view.width),
                                  (high.y() - low.y()) / (kFill * view.height));
    view.eye += view.axes.col(2) * depth * std::min(0.5, 1 - fills);
  }
}

}  // namespace

Rays::Rays(const View& view)
    : parallel_(view.parallel),
      right_(view.axes.col(0) / view.fx),
      down_(view.axes.col(1) / view.fy),
      corner_((view.parallel ? view.eye : Vec3(view.axes.col(2))) - view.cx * right_ -
              view.cy * down_),
      shared_(view.parallel ? Vec3(view.axes.col(2)) : view.eye),
      pixel_(1 / view.fx) {}

View enlarged(const View& view, int n) {
  View out = view;
  out.width *= n;
  out.height *= n;
  out.fx *= n;
  out.fy *= n;
  out.cx = (view.cx + 0.5) * n - 0.5;
  out.cy = (view.cy + 0.5) * n - 0.5;
  return out;
}

Vec3 project(const View& view, const Vec3& point) {
  const Vec3 local = view.axes.transpose() * (point - view.eye);
  const double scale = view.parallel ? 1 : 1 / local.z();
  return {view.cx + view.fx * local.x() * scale, view.cy + view.fy * local.y() * scale, local.z()};
}

View plan_view(const Aabb& region, int width, int height) {
  View view;
  view.width = width;
  view.height = height;
  view.parallel = true;
  const Vec3 size = (region.max - region.min).cwiseMax(1.0);
  view.fx = view.fy = kFill * std::min(width / size.x(), height / size.y());
  put_middle_at_centre(view);
  view.eye = 0.5 * (region.min + region.max);
  view.eye.z() = region.max.z() + 1;
  view.axes.col(0) = Vec3::UnitX();
  view.axes.col(1) = -Vec3::UnitY();
  view.axes.col(2) = -Vec3::UnitZ();
  return view;
}

View overview(const Aabb& region, int width, int height, const OverviewOptions& options) {
  View view;
  view.width = width;
  view.height = height;
  put_middle_at_centre(view);
  view.fx = view.fy = 0.5 * width / std::tan(0.5 * options.field_of_view);
  const Vec3 ahead(std::sin(options.azimuth), std::cos(options.azimuth), 0);
  const Vec3 right(ahead.y(), -ahead.x(), 0);
  view.axes.col(0) = right;
  view.axes.col(2) =
      std::cos(options.elevation) * ahead - std::sin(options.elevation) * Vec3::UnitZ();
  view.axes.col(1) = view.axes.col(2).cross(right);
  fit(region, view);
  return view;
}

}  // namespace geom::picture
