#pragma once

// Questions and boxes of a peer in single precision: relative to a corner, bounds padded by more
// than what rounding loses.

#include <algorithm>
#include <cmath>
#include <span>

#include "geom/base/rounding.h"
#include "geom/shape/aabb.h"

namespace bench {

using geom::Aabb;
using geom::Vec3;

// Boxes that a region has room for at once: few regions have more.
inline constexpr std::size_t kFew = 32;

class PeerFrame {
 public:
  explicit PeerFrame(std::span<const Aabb> boxes) {
    const Aabb all = *geom::bounds(boxes);
    corner_ = all.min;
    pad_ = std::max(1e-3, std::ldexp((all.max - all.min).maxCoeff() + 1000, -20));
  }

  double pad() const { return pad_; }  // metres
  Eigen::Vector3f at(const Vec3& p) const { return (p - corner_).cast<float>(); }

  float low(const Aabb& box, int axis) const {
    return geom::float_down(box.min[axis] - corner_[axis] - pad_);
  }
  float high(const Aabb& box, int axis) const {
    return geom::float_up(box.max[axis] - corner_[axis] + pad_);
  }

  // No box of which the computed square is larger is as near as this.
  float limit(double distance) const {
    return geom::float_up((distance + 2 * pad_) * (distance + 2 * pad_));
  }

 private:
  Vec3 corner_;
  double pad_;
};

// A segment for the slab test (Kay and Kajiya 1986).
struct PeerSegment {
  Eigen::Vector3f from;
  Eigen::Vector3f inverse;

  PeerSegment(const PeerFrame& frame, const Vec3& a, const Vec3& b) : from(frame.at(a)) {
    Eigen::Vector3f along = (b - a).cast<float>();
    for (float& d : along) d = std::abs(d) < 1e-9f ? 1e-9f : d;
    inverse = along.cwiseInverse();
  }
};

}  // namespace bench
