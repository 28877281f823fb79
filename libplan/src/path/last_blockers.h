#pragma once

// Whether segments are free, where many are asked in turn that lie beside each other.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "blocker_lanes.h"
#include "geom/base/precondition.h"
#include "geom/collision/collision.h"

namespace plan {

// Most of what a search asks is blocked, and mostly by a box that blocked a segment shortly before:
// the last few are asked first. The answers are the scene's, bit for bit. The scene must outlive
// it; one thread at a time.
class LastBlockers {
 public:
  explicit LastBlockers(const geom::CollisionScene& scene) : scene_(&scene) {}

  // scene.hits(a, b).
  bool hits(const Vec3& a, const Vec3& b) {
    geom::require_points("segment", a, b);
    if (const unsigned hit = boxes_.hit_by(a, b)) {
      used_[static_cast<std::size_t>(std::countr_zero(hit))] = ++now_;
      return true;
    }
    const auto box = scene_->blocker(a, b);
    if (!box) return false;
    const auto oldest = std::min_element(used_.begin(), used_.end());
    boxes_.put(static_cast<std::size_t>(oldest - used_.begin()), *box);
    *oldest = ++now_;
    return true;
  }

  // True only where one of the last boxes that blocked a segment blocks all from `a` to the points
  // of the closed box.
  bool hides(const Vec3& a, const geom::Aabb& box) const { return boxes_.hiding(a, box) != 0; }

  // scene.free(a, b).
  bool free(const Vec3& a, const Vec3& b) {
    return scene_->inside_bounds(a) && scene_->inside_bounds(b) && !hits(a, b);
  }

 private:
  const geom::CollisionScene* scene_;
  BlockerLanes boxes_;
  std::array<std::size_t, BlockerLanes::kLanes> used_{};  // when each last blocked a segment
  std::size_t now_ = 0;
};

}  // namespace plan
