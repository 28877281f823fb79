#include "geom/vehicle/vehicle.h"

#include <cmath>
#include <limits>

namespace geom {
namespace {

// max over 0 <= t <= tilt_max of p cos t + q sin t, rounded up past the error of libm.
double reach(double p, double q, double tilt_max) {
  const double peak = std::atan2(q, p);
  const double value =
      peak <= tilt_max ? std::hypot(p, q) : p * std::cos(tilt_max) + q * std::sin(tilt_max);
  return value * (1 + 8 * std::numeric_limits<double>::epsilon());
}

}  // namespace

Vec3 attitude_half_sizes(const Vec3& body, double tilt_max) {
  const double radius = std::hypot(body.x(), body.y());
  const double horizontal = reach(radius, body.z(), tilt_max);
  const double vertical = reach(body.z(), radius, tilt_max);
  return {horizontal, horizontal, vertical};
}

}  // namespace geom
