#include "plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geom/base/precondition.h"
#include "geom/base/rounding.h"

namespace geom {

std::vector<Vec3> corners_of(const Footprint& footprint) {
  std::vector<Vec3> out;
  const auto add = [&](const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) {
      const std::size_t i = out.size();
      const double z = i < footprint.heights.size() ? footprint.heights[i] : footprint.top;
      out.push_back({p.x(), p.y(), z});
    }
  };
  add(footprint.polygon.outer);
  for (const auto& hole : footprint.polygon.holes) add(hole);
  return out;
}

PlaneFit fit_plane(const std::vector<Vec3>& corners) {
  PlaneFit out;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : corners) mean += p / static_cast<double>(corners.size());
  out.centre = mean.head<2>();
  out.base = mean.z();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Vec2 rise = Vec2::Zero();
  for (const Vec3& p : corners) {
    const Vec2 d = p.head<2>() - out.centre;
    spread += d * d.transpose();
    rise += d * (p.z() - mean.z());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  out.across = axes.eigenvectors().col(0);
  out.along = axes.eigenvectors().col(1);
  for (int i = 0; i < 2; ++i) {
    const Vec2 axis = axes.eigenvectors().col(i);
    const double value = axes.eigenvalues()[i];
    if (value > 1e-12 * axes.eigenvalues()[1] && value > 0) {
      out.gradient += axis * (axis.dot(rise) / value);
    }
  }
  out.low = out.high = corners.front().z();
  for (const Vec3& p : corners) {
    const Vec2 at = p.head<2>();
    out.residual = std::max(out.residual, std::abs(p.z() - out(at)));
    out.low = std::min(out.low, p.z());
    out.high = std::max(out.high, p.z());
    const double aside = out.across.dot(at - out.centre);
    out.across_low = std::min(out.across_low, aside);
    out.across_high = std::max(out.across_high, aside);
  }
  out.residual +=
      1e-9 + 8 * ulp(std::max(std::abs(out.low), std::abs(out.high))) + 1e-9 * out.gradient.norm();
  return out;
}

bool is_upright(const PlaneFit& plane, double slack) { return plane.thickness() <= slack / 4; }

}  // namespace geom
