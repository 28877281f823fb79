#pragma once

// Small scenes with two places that do not see each other, and a path between them that is near to
// shortest: what bounds on length are held against.

#include <cstdint>
#include <optional>

#include "plan/scenes.h"
#include "support/fine_path.h"

namespace plan {

// A few boxes in a room of 10 m; in half of the scenes on whole metres, so that faces are flush.
inline geom::CollisionScene scene_for(std::uint64_t seed) {
  support::Random random(seed);
  std::vector<geom::Aabb> boxes;
  if (seed % 2) {
    boxes = random_boxes(random, 2 + random.below(7), 10);
  } else {
    for (int i = 2 + random.below(9); i > 0; --i) {
      geom::Vec3 low;
      geom::Vec3 size;
      for (int k = 0; k < 3; ++k) {
        low[k] = random.stepped(0, 8, 1);
        size[k] = random.stepped(1, 5, 1);
      }
      boxes.push_back({low, low + size});
    }
  }
  return scene_of(boxes, {{0, 0, 0}, {10, 10, 10}},
                  geom::Vec3::Constant(random.below(2) ? 0.25 : 0.5));
}

inline std::optional<geom::Vec3> free_place(const geom::CollisionScene& scene,
                                            support::Random& random) {
  for (int i = 0; i < 100; ++i) {
    geom::Vec3 p;
    for (int k = 0; k < 3; ++k) {
      p[k] = random.below(3) ? random.uniform(0.5, 9.5) : random.stepped(0.5, 9.5, 0.25);
    }
    if (scene.free(p)) return p;
  }
  return std::nullopt;
}

struct Detour {
  geom::CollisionScene scene;
  geom::Vec3 from;
  geom::Vec3 to;
  double length = 0;  // of a path that the scene calls free
};

// Nothing where the two places see each other, or no path is found.
inline std::optional<Detour> detour_for(std::uint64_t seed) {
  geom::CollisionScene scene = scene_for(seed);
  support::Random random(seed + 1000);
  const auto from = free_place(scene, random);
  const auto to = free_place(scene, random);
  if (!from || !to || scene.free(*from, *to)) return std::nullopt;
  const geom::Polyline path = oracle::fine_path(scene, *from, *to, 1);
  if (path.empty()) return std::nullopt;
  return Detour{std::move(scene), *from, *to, geom::length(path)};
}

}  // namespace plan
