#pragma once

// A path that is near to shortest, found the slow way: over points close together along all edges
// of all grown boxes, every leg asked of the scene; then pulled taut.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "path/taut.h"

namespace oracle {

// Free points `off` metres outside the edges, at most `step` metres apart.
inline std::vector<geom::Vec3> beside_edges(const geom::CollisionScene& scene, double step,
                                            double off) {
  std::vector<geom::Vec3> out;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const geom::Aabb box = scene.grown(i);
    for (int k = 0; k < 3; ++k) {
      const double length = box.max[k] - box.min[k];
      const int parts = static_cast<int>(std::ceil(length / step));
      for (int corner = 0; corner < 4; ++corner) {
        for (int n = 0; n <= parts; ++n) {
          geom::Vec3 p;
          p[k] = box.min[k] + length * n / parts;
          const int a = (k + 1) % 3;
          const int b = (k + 2) % 3;
          p[a] = corner & 1 ? box.max[a] + off : box.min[a] - off;
          p[b] = corner & 2 ? box.max[b] + off : box.min[b] - off;
          if (scene.free(p)) out.push_back(p);
        }
      }
    }
  }
  return out;
}

// Empty where there is none. Also by way of the free ones of some other points.
inline geom::Polyline fine_path(const geom::CollisionScene& scene, const geom::Vec3& from,
                                const geom::Vec3& to, double step,
                                const std::vector<geom::Vec3>& others = {}) {
  std::vector<geom::Vec3> points = beside_edges(scene, step, 1e-6);
  for (const geom::Vec3& p : others) {
    if (scene.free(p)) points.push_back(p);
  }
  points.push_back(from);
  points.push_back(to);
  const std::size_t goal = points.size() - 1;
  std::vector<double> cost(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> parent(points.size(), goal);
  std::vector<char> settled(points.size(), 0);
  cost[goal - 1] = 0;
  while (!settled[goal]) {
    std::size_t best = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!settled[i] && (best == points.size() || cost[i] < cost[best])) best = i;
    }
    if (!(cost[best] < std::numeric_limits<double>::infinity())) return {};
    settled[best] = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double through = cost[best] + (points[i] - points[best]).norm();
      if (settled[i] || through >= cost[i] || !scene.free(points[best], points[i])) continue;
      cost[i] = through;
      parent[i] = best;
    }
  }
  geom::Polyline path{to};
  for (std::size_t i = goal; i != goal - 1;) path.push_back(points[i = parent[i]]);
  std::reverse(path.begin(), path.end());
  const geom::Polyline pulled = plan::taut(scene, path);
  return geom::length(pulled) < geom::length(path) ? pulled : path;
}

}  // namespace oracle
