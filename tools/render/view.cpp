#include "render/view.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double kFill = 0.94;  // of the picture, by what is shown

void put_middle_at_centre(View& view) {
  view.cx = 0.5 * (view.width - 1);
  view.cy = 0.5 * (view.height - 1);
}

Vec3 corner(const geom::Aabb& box, int i) {
  return {i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
          i & 4 ? box.max.z() : box.min.z()};
}

}  // namespace

Ray ray_through(const View& view, double u, double v) {
  const double right = (u - view.cx) / view.fx;
  const double down = (v - view.cy) / view.fy;
  const Vec3 across = view.axes.col(0) * right + view.axes.col(1) * down;
  if (view.parallel) return {view.eye + across, view.axes.col(2)};
  return {view.eye, across + view.axes.col(2)};
}

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

View plan_view(const geom::Aabb& region, int width, int height) {
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

View overview(const geom::Aabb& region, int width, int height, const OverviewOptions& options) {
  View view;
  view.width = width;
  view.height = height;
  put_middle_at_centre(view);
  view.fx = view.fy = 0.5 * width / std::tan(0.5 * options.field_of_view);
  const Vec3 ahead(std::sin(options.azimuth), std::cos(options.azimuth), 0);
  const Vec3 right(ahead.y(), -ahead.x(), 0);
  view.axes.col(0) = right;
  view.axes.col(2) = std::cos(options.elevation) * ahead - std::sin(options.elevation) * Vec3::UnitZ();
  view.axes.col(1) = view.axes.col(2).cross(right);
  const Vec3 middle = 0.5 * (region.min + region.max);
  // Each corner must be far enough ahead to lie within the frame's half width and half height.
  double back = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 local = view.axes.transpose() * (corner(region, i) - middle);
    const double across = std::max(std::abs(local.x()) * view.fx / (0.5 * width),
                                   std::abs(local.y()) * view.fy / (0.5 * height));
    back = std::max(back, across / kFill - local.z());
  }
  view.eye = middle - view.axes.col(2) * std::max(back, 1.0);
  return view;
}

}  // namespace render
