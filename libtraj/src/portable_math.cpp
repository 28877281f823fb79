#include "portable_math.h"

#include <algorithm>

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

}  // namespace traj
