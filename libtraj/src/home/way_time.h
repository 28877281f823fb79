#pragma once

// How long a way home takes at most.

#include <optional>
#include <span>
#include <vector>

#include "geom/shape/polyline.h"
#include "geom/vehicle/limits.h"
#include "home/braking.h"
#include "traj/flight/energy.h"
#include "traj/home/return_model.h"

namespace traj {

// The speeds that an autopilot keeps to on a way home, m/s.
struct WaySpeeds {
  double across = 0;   // over the ground, against the wind
  double fastest = 0;  // without wind
  double climb = 0;
  double descent = 0;
};

// By whichever of some models flies.
class WayTime {
 public:
  // `models` must outlive this. Throws InputError where the wind leaves a model no speed.
  WayTime(std::span<const ReturnModel> models, const geom::Limits& limits,
          const std::optional<Energy>& energy);

  // Seconds from the order, anywhere in a stage, until it stands on the ground at the last of
  // `points`, at most; at least two points.
  double at_most(const Braking& from, const geom::Polyline& points) const;

 private:
  std::span<const ReturnModel> models_;
  std::vector<WaySpeeds> speeds_;
};

}  // namespace traj
