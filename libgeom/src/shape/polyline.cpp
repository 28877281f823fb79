#include "geom/shape/polyline.h"

#include <cmath>

namespace geom {

double length(const Polyline& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

Polyline resample(const Polyline& path, double step) {
  Polyline points;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      const Vec3& a = path[i - 1];
      const Vec3& b = path[i];
      const double parts = std::ceil((b - a).norm() / step);
      for (double k = 1; k < parts; ++k) points.push_back(a + (b - a) * (k / parts));
    }
    points.push_back(path[i]);
  }
  return points;
}

}  // namespace geom
