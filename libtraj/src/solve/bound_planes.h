#pragma once

// The faces of a box around a piece of the path, as planes that the piece is behind.

#include <algorithm>
#include <vector>

#include "traj/solve/corridor.h"

namespace traj {

inline constexpr double kLargestPull = 1e-3;  // metres

// Pulled in by min(1 mm, half the gap), as other planes are.
inline std::vector<Separation> bound_planes(const CorridorPiece& piece, const geom::Aabb& inner) {
  std::vector<Separation> planes;
  for (int i = 0; i < 3; ++i) {
    const double up = inner.max[i] - std::max(piece.from[i], piece.to[i]);
    const double down = std::min(piece.from[i], piece.to[i]) - inner.min[i];
    const auto pull = [](double gap) { return std::clamp(gap / 2, 0.0, kLargestPull); };
    planes.push_back({{Vec3::Unit(i), inner.max[i] - pull(up)}, up});
    planes.push_back({{-Vec3::Unit(i), -inner.min[i] - pull(down)}, down});
  }
  return planes;
}

}  // namespace traj
