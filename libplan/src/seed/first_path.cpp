#include "first_path.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "half_plane.h"

namespace plan {
namespace {

struct Slant {
  double up;    // cosine and sine of the angle from upright
  double side;  // to the right
};

// By 30 degrees. Upright first: what is longer is given up early, and level chains take longest.
constexpr double kCosine = 0.86602540378443865;  // of 30 degrees
constexpr std::array<Slant, 7> kSlants{
    {{1, 0}, {kCosine, 0.5}, {kCosine, -0.5}, {0.5, kCosine}, {0.5, -kCosine}, {0, 1}, {0, -1}}};
constexpr std::size_t kFirst = 3;    // that are always looked at
constexpr std::size_t kLevel = 5;    // from here on they are level
constexpr double kPromising = 1.05;  // of the straight line

}  // namespace

geom::Polyline first_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                          const FirstPathLimits& limits) {
  const double straight = (to - from).norm();
  const Vec3 along = (to - from) / straight;
  const Vec3 side = along.cross(std::abs(along.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX());
  const Vec3 right = side.normalized();
  const Vec3 up = right.cross(along);
  geom::Polyline best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kSlants.size() && least > limits.enough * straight; ++i) {
    const bool promising = least <= kPromising * straight && i < kLevel;
    const bool hopeless = i > 0 && least > limits.hopeless * straight;
    if (straight > kFarChain && (hopeless || (i >= kFirst && !promising))) break;
    const HalfPlane half(from, to, kSlants[i].up * up + kSlants[i].side * right);
    geom::Polyline path = chain_in(scene, half, least);
    if (path.empty()) continue;
    least = geom::length(path);
    best = std::move(path);
  }
  return best;
}

}  // namespace plan
