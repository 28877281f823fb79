#pragma once

// Whether segments are free, where many are asked in turn that lie beside each other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "geom/base/precondition.h"
#include "geom/collision/collision.h"

namespace plan {

using geom::Vec3;

// Most of what a search asks is blocked, and mostly by a box that blocked a segment shortly before:
// the last few are asked first. The answers are the scene's, bit for bit. The scene must outlive
// it; one thread at a time.
class LastBlockers {
 public:
  explicit LastBlockers(const geom::CollisionScene& scene) : scene_(&scene) {}

  // scene.hits(a, b).
  bool hits(const Vec3& a, const Vec3& b) {
    geom::require_points("segment", a, b);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!geom::segment_hits(a, b, boxes_[i])) continue;
      if (i > 0) std::swap(boxes_[i], boxes_[i - 1]);
      return true;
    }
    const auto box = scene_->blocker(a, b);
    if (!box) return false;
    count_ = std::min(count_ + 1, kKept);
    boxes_[count_ - 1] = *box;
    return true;
  }

  // True only where one of the last boxes that blocked a segment blocks all from `a` to the points
  // of the closed box.
  bool hides(const Vec3& a, const geom::Aabb& box) const {
    for (std::size_t i = 0; i < count_; ++i) {
      if (hides(a, box, boxes_[i])) return true;
    }
    return false;
  }

  // scene.free(a, b).
  bool free(const Vec3& a, const Vec3& b) {
    return scene_->inside_bounds(a) && scene_->inside_bounds(b) && !hits(a, b);
  }

 private:
  // Whether the box, seen from `a`, lies behind a side of the blocker and within its outline, with
  // a micrometre to spare: far more than what is rounded.
  static bool hides(const Vec3& a, const geom::Aabb& box, const geom::Aabb& blocker) {
    constexpr double kSpare = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const bool above = blocker.min[k] > a[k];
      if (!above && !(blocker.max[k] < a[k])) continue;
      const double side = above ? blocker.min[k] - a[k] : a[k] - blocker.max[k];
      const double near = above ? box.min[k] - a[k] : a[k] - box.max[k];
      const double far = above ? box.max[k] - a[k] : a[k] - box.min[k];
      if (!(near > side)) return false;
      bool within = true;
      for (const int j : {(k + 1) % 3, (k + 2) % 3}) {
        const double low = box.min[j] - a[j];
        const double high = box.max[j] - a[j];
        within = within && low * side / (low < 0 ? near : far) >= blocker.min[j] - a[j] + kSpare &&
                 high * side / (high > 0 ? near : far) <= blocker.max[j] - a[j] - kSpare;
      }
      if (within) return true;
    }
    return false;
  }

  static constexpr std::size_t kKept = 4;

  const geom::CollisionScene* scene_;
  std::array<geom::Aabb, kKept> boxes_{};
  std::size_t count_ = 0;
};

}  // namespace plan
