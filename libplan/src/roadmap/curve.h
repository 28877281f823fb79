#pragma once

// A curve through a cube, along which places that are near each other mostly follow each other.

#include <algorithm>
#include <cstdint>

#include "geom/shape/aabb.h"

namespace plan {

// Morton 1966.
class Curve {
 public:
  // Through a cube that holds the box.
  explicit Curve(const geom::Aabb& around) : low_(around.min) {
    const double side = (around.max - around.min).maxCoeff();
    scale_ = side > 0 ? ((1 << kBits) - 1) / side : 0;
  }

  // Where a point of the box, or one beside it, lies along the curve.
  std::uint64_t place(const geom::Vec3& p) const {
    std::uint64_t out = 0;
    for (int k = 0; k < 3; ++k) {
      const double step = std::clamp((p[k] - low_[k]) * scale_, 0.0, (1 << kBits) - 1.0);
      out |= spread(static_cast<std::uint64_t>(step)) << k;
    }
    return out;
  }

 private:
  static constexpr int kBits = 20;  // of each coordinate

  // Every third bit, from the lowest on, is one of `x`.
  static std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  geom::Vec3 low_;
  double scale_;
};

}  // namespace plan
