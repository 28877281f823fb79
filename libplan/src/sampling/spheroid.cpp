#include "spheroid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plan {

using geom::Vec3;

Spheroid::Spheroid(const Vec3& from, const Vec3& to, double length)
    : from_(from), to_(to), length_(std::max(length, (to - from).norm())) {
  const double distance = (to - from).norm();
  const Vec3 along = distance > 0 ? Vec3((to - from) / distance) : Vec3(Vec3::UnitX());
  int least = 0;
  along.cwiseAbs().minCoeff(&least);
  const Vec3 across = along.cross(Vec3::Unit(least)).normalized();
  const double half_width = std::sqrt((length_ - distance) * (length_ + distance)) / 2;
  axis_[0] = length_ / 2 * along;
  axis_[1] = half_width * across;
  axis_[2] = half_width * along.cross(across);
}

double Spheroid::volume() const {
  return 4 * std::numbers::pi / 3 * axis_[0].norm() * axis_[1].squaredNorm();
}

bool Spheroid::contains(const Vec3& p) const {
  return (p - from_).norm() + (to_ - p).norm() <= length_;
}

Vec3 Spheroid::image(const Vec3& unit) const {
  return 0.5 * (from_ + to_) + (unit[0] * axis_[0] + unit[1] * axis_[1] + unit[2] * axis_[2]);
}

}  // namespace plan
