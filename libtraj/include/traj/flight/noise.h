#pragma once

// Normally distributed numbers from a seeded generator.
//
// Example:
//   traj::Gaussian noise(7);  // the seed
//   const double error = 0.05 * noise.next();

#include <cmath>

#include "geom/base/random.h"
#include "geom/base/vec3.h"

namespace traj {

// Marsaglia's polar method. Uses log: the same numbers on the same libm.
class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : random_(seed) {}

  double next() {  // mean 0, deviation 1
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double u, v, s;
    do {
      u = random_.uniform(-1, 1);
      v = random_.uniform(-1, 1);
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double scale = std::sqrt(-2 * std::log(s) / s);
    spare_ = v * scale;
    has_spare_ = true;
    return u * scale;
  }

  geom::Vec3 vector() {
    const double x = next();
    const double y = next();
    return {x, y, next()};
  }

 private:
  geom::SplitMix64 random_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace traj
