#pragma once

// What the boxes around a point surely hide from it, so that most of what it does not see need not
// be asked of the scene.

#include <array>
#include <cstddef>

#include "geom/collision/collision.h"

namespace plan {

using geom::Vec3;

// Directions in plan are cut into sectors, equal on the square |x| + |y| = 1, which stands for a
// circle: distances in plan are |x| + |y| too. In each, one box or several that overlap as seen
// from the eye hide a range of slopes, from some distance on.
class Shadows {
 public:
  Shadows(const geom::CollisionScene& scene, const Vec3& eye);

  // True only where the scene has a box that the straight line from the eye to `p` hits, with a
  // micrometre to spare.
  bool hides(const Vec3& p) const;

  // The same for all points of the closed box at once. Faces may be off by rounding.
  bool hides(const geom::Aabb& box) const;

 private:
  static constexpr std::size_t kSectors = 128;  // a multiple of 4

  struct Hidden {
    double beyond = 0;  // distance in plan
    double low = 1;     // slopes, of height over distance in plan; none where low > high
    double high = -1;
  };

  void add(const geom::Aabb& box);
  void add(std::size_t sector, const geom::Aabb& box);

  Vec3 eye_;
  std::array<Hidden, kSectors> hidden_;
};

}  // namespace plan
