#pragma once

// Whether the parts of a way home are clear, with what the vehicle overshoots at its stops.

#include <span>

#include "geom/collision/collision.h"
#include "home/braking.h"
#include "traj/home/return_model.h"

namespace traj {

// By whichever of some models flies.
class WayRoom {
 public:
  // The scene must outlive this.
  WayRoom(const geom::CollisionScene& scene, std::span<const ReturnModel> models);

  // Every straight way from the region to a place, and beyond the place as far as it is overshot.
  bool joins(const Braking& from, const Vec3& to) const;

  // The leg, and as far beyond its end.
  bool leg(const Vec3& a, const Vec3& b) const;

  // The most that is overshot at a stop, m.
  double overshoot() const { return overshoot_; }

  // What is overshot beyond a place, from anywhere in the region; and beyond the end of a leg.
  Prism beyond(const Braking& from, const Vec3& to) const;
  Prism beyond(const Vec3& a, const Vec3& b) const;

 private:
  const geom::CollisionScene& scene_;
  double overshoot_ = 0;
};

}  // namespace traj
