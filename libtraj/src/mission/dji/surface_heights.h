#pragma once

// How high an aircraft may be that follows the surface below it as its sensors see it.

#include <span>
#include <string>
#include <string_view>

#include "mission/flown/flown_regions.h"
#include "traj/mission/flown/terrain_rules.h"

namespace traj {

struct SurfaceRange {
  double low = 0;
  double high = 0;

  double middle() const { return (low + high) / 2; }
};

// The heights over the ground of a model that the aircraft's operator states.
class SurfaceHeights {
 public:
  // `around`: metres, along each axis, that the aircraft may be from the places that are asked for.
  // Precondition: rules.surface.
  SurfaceHeights(const TerrainRules& rules, double around, std::string_view source)
      : rules_(rules), around_(around), source_(source) {}

  // z anywhere over the rectangle that holds these places (in ENU), rounded outward. Throws
  // geom::InputError(source, …) where the model does not know the ground there.
  SurfaceRange over(std::span<const Vec3> places) const;

  // Each of these places twice: at the least height over all of them, and at the greatest.
  Hull raised(std::span<const Vec3> places) const;

 private:
  TerrainRules rules_;
  double around_;
  std::string source_;
};

}  // namespace traj
