#pragma once

// Small scenes that the tests of this folder share.

#include <utility>
#include <vector>

#include "geom/collision/collision.h"
#include "support/random_city.h"
#include "support/small_map.h"

namespace plan {

inline geom::CollisionScene scene_of(std::vector<geom::Aabb> boxes, const geom::Aabb& bounds,
                                     const geom::Vec3& half = geom::Vec3::Zero(),
                                     double margin = 0) {
  return {support::map_of(bounds, std::move(boxes)), {"box", half}, margin};
}

// 60 houses of a city within 200 m, and a vehicle of half a metre's height.
inline geom::CollisionScene small_city(std::uint64_t seed) {
  return {support::random_city(seed, 60, 200), {"box", {1, 1, 0.5}}, 0.25};
}

// Boxes in [0, side]^3: half of the faces on whole metres, the rest anywhere, some flat.
inline std::vector<geom::Aabb> random_boxes(support::Random& random, int count, double side) {
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    geom::Vec3 low;
    geom::Vec3 size;
    for (int k = 0; k < 3; ++k) {
      low[k] = random.below(2) ? random.stepped(0, side, 1) : random.uniform(0, side);
      size[k] = random.below(2) ? random.stepped(0, 4, 1) : random.uniform(0, 3);
    }
    boxes.push_back({low, low + size});
  }
  return boxes;
}

inline geom::CollisionScene random_scene(std::uint64_t seed, int count, double side,
                                         const geom::Vec3& half) {
  support::Random random(seed);
  return scene_of(random_boxes(random, count, side),
                  {geom::Vec3::Zero(), geom::Vec3::Constant(side)}, half);
}

}  // namespace plan
