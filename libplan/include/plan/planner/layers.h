#pragma once

// Cruise altitudes by direction, so that flights which cross are at different heights.
//
// Example:
//   const plan::Layers layers{.low = 1, .step = 2, .count = 4};  // from 1 m up
//   plan::Planner whole(scene);
//   plan::LayerPlanner planner(scene, whole, layers);
//   assert(plan::layer_of(layers, geom::Axes::enu, {1, 1, 1}, {9, 1, 1}) == 1);  // to the east
//   const plan::PlanResult result = planner.plan({1, 1, 1}, {9, 1, 1});
//
// This is the rule of layered airspace (Sunil et al., "Metropolis: Relating Airspace Structure and
// Capacity for Extreme Traffic Densities", ATM seminar 2015).

#include <memory>
#include <utility>

#include "geom/collision/collision.h"
#include "plan/planner/plan.h"

namespace plan {

// Layer k holds the reference point between low + k step and low + (k + 1) step, both closed. It is
// for flights whose goal lies, clockwise from north, at k to before k + 1 shares of 360 degrees.
struct Layers {
  double low = 0;   // metres, z of the map
  double step = 0;  // metres, > 0
  int count = 0;    // >= 1

  std::pair<double, double> span(int layer) const;
};

// By the direction over the ground; straight up or down counts as north.
int layer_of(const Layers& layers, geom::Axes axes, const Vec3& from, const Vec3& to);

// Plans through the layer of the direction, from and to the places in it that are nearest to the
// ends (nearest_free(), within 200 m): Planner's recipe within the layer, and Planner's, over the
// whole map, from and to the ends. What it finds is longer than Planner's path, or as long.
// A layer's part of the map is copied when a flight first needs it. Threads may plan at once.
class LayerPlanner {
 public:
  // Both must outlive it; `whole` plans on `scene`. InputError where a layer is none.
  LayerPlanner(const geom::CollisionScene& scene, Planner& whole, const Layers& layers);
  ~LayerPlanner();

  // `options` have the method auto, and neither a bound nor resampling. If a part of the way is not
  // found, the result has the status of that part, and its message says which part it was.
  PlanResult plan(const Vec3& from, const Vec3& to, const PlanOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
