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

  // scene.free(a, b).
  bool free(const Vec3& a, const Vec3& b) {
    return scene_->inside_bounds(a) && scene_->inside_bounds(b) && !hits(a, b);
  }

 private:
  static constexpr std::size_t kKept = 4;

  const geom::CollisionScene* scene_;
  std::array<geom::Aabb, kKept> boxes_{};
  std::size_t count_ = 0;
};

}  // namespace plan
