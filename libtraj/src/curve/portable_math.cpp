#include "portable_math.h"

#include <algorithm>
#include <cmath>

namespace traj {

double cube_root(double x) {
  if (x <= 0) return 0;
  // Newton's method from above decreases until rounding stops it.
  double r = std::max(x, 1.0);
  for (;;) {
    const double next = (2 * r + x / (r * r)) / 3;
    if (!(next < r)) return r;
    r = next;
  }
}

double tangent_below(double angle) {
  const double square = angle * angle;
  double sine = 0;
  double cosine = 0;
  double term = 1;  // angle^n / n!
  for (int n = 0; n < 30; n += 2) {
    const double sign = n % 4 == 0 ? 1 : -1;
    cosine += sign * term;
    sine += sign * term * angle / (n + 1);
    term *= square / ((n + 1) * (n + 2));
  }
  return std::max(0.0, sine / cosine * (1 - 1e-12));
}

double angle_of(double x, double y) {
  const double most = std::max(std::abs(x), std::abs(y));
  const double least = std::min(std::abs(x), std::abs(y));
  // atan(u) = 2 atan(u / (1 + sqrt(1 + u^2))), four times, then its series.
  double u = least / most;
  for (int i = 0; i < 4; ++i) u /= 1 + std::sqrt(1 + u * u);
  double sum = 0;
  double power = u;
  for (int n = 1; n < 20; n += 2) {
    sum += (n % 4 == 1 ? 1 : -1) * power / n;
    power *= u * u;
  }
  double angle = 16 * sum;
  if (std::abs(y) > std::abs(x)) angle = kPi / 2 - angle;
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace traj
