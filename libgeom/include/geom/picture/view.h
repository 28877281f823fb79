#pragma once

// From where and how a picture is taken.
//
// Example:
//   const geom::picture::View view =
//       geom::picture::plan_view({{0, 0, 0}, {100, 50, 20}}, 640, 480);
//   const geom::picture::Ray ray = geom::picture::Rays(view).through(320, 240);  // a pixel's
//   const geom::Vec3 at = geom::picture::project(view, {50, 25, 0});  // column, row, depth
//   assert(std::abs(at.x() - 319.5) < 1e-6);

#include <Eigen/Core>

#include "geom/shape/aabb.h"

namespace geom::picture {

// Pixels count from the upper left; the centre of pixel (i, j) is at (i, j). Everything in ENU
// axes and metres.
struct View {
  int width = 640;
  int height = 480;
  Vec3 eye = Vec3::Zero();
  // Columns: right, down and forward in the picture; orthonormal.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // Perspective: focal lengths in pixels. Parallel: pixels per metre.
  double fx = 1;
  double fy = 1;
  double cx = 0;
  double cy = 0;
  bool parallel = false;  // rays along `forward`, which start in the plane through the eye
};

// A ray whose parameter is the depth: its direction has the forward component 1.
struct Ray {
  Vec3 origin;
  Vec3 direction;
};

// The rays of a view.
class Rays {
 public:
  explicit Rays(const View& view);

  Ray through(double u, double v) const {
    const Vec3 across = corner_ + u * right_ + v * down_;
    if (parallel_) return {across, shared_};
    return {shared_, across};
  }
  bool parallel() const { return parallel_; }
  // through(u, v) has corner() + u * right() + v * down(), and shared().
  const Vec3& corner() const { return corner_; }
  const Vec3& right() const { return right_; }
  const Vec3& down() const { return down_; }
  const Vec3& shared() const { return shared_; }
  double pixel() const { return pixel_; }  // metres across at a depth of one metre, or anywhere

 private:
  bool parallel_;
  Vec3 right_;  // from pixel to pixel
  Vec3 down_;
  Vec3 corner_;  // what pixel (0, 0) has: the direction, or where a parallel ray starts
  Vec3 shared_;  // by all rays: the eye, or the direction of parallel ones
  double pixel_;
};

// The picture at n times the resolution.
View enlarged(const View& view, int n);

// Pixel and depth of a point; only with a depth > 0 is it in front of a perspective view.
Vec3 project(const View& view, const Vec3& point);

// From above, north up and parallel: all of `region`, ENU, in the middle of the picture.
View plan_view(const Aabb& region, int width, int height);

// In perspective from outside: all corners of `region` in the picture. Radians: `azimuth` is the
// compass direction in which one looks, from north clockwise, `elevation` how far one looks down
// (0 to pi/2).
struct OverviewOptions {
  double azimuth = 0.6;
  double elevation = 0.6;
  double field_of_view = 0.7;  // across the width
};
View overview(const Aabb& region, int width, int height, const OverviewOptions& options);

}  // namespace geom::picture
