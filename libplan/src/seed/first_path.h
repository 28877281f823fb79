#pragma once

// A path before any search: over or round what stands on the straight line.

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

using geom::Vec3;

inline constexpr double kFarChain = 150;  // metres between places that are far from each other

// Times the straight line.
struct FirstPathLimits {
  double enough = 1;      // once a chain is as short as this, no other is looked for
  double hopeless = 1e9;  // nor between far places if the upright chain is longer than this
};

// The shortest chain_in() a few half-planes beside the straight line: upright, slanting and, where
// the places are near each other, level. Where they are far and the first three promise little, no
// more are looked at. Empty where no half-plane has a chain. The places are free and do not see
// each other. Deterministic.
geom::Polyline first_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                          const FirstPathLimits& limits = {});

}  // namespace plan
