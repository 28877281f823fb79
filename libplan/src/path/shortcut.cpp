#include "path/shortcut.h"

#include <algorithm>
#include <limits>

#include "last_blockers.h"

namespace plan {
namespace {

using geom::Polyline;
using geom::Vec3;

constexpr double kPoints = 120;  // a round's points, about

// The shortest free chain from the first to the last point that visits points in order. The
// neighbours in `points` see each other.
Polyline shortest_chain(const geom::CollisionScene& scene, const Polyline& points) {
  LastBlockers blockers(scene);
  const std::size_t n = points.size();
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(n, 0);
  cost[0] = 0;
  for (std::size_t j = 1; j < n; ++j) {
    cost[j] = cost[j - 1] + (points[j] - points[j - 1]).norm();
    from[j] = j - 1;
    for (std::size_t i = 0; i + 1 < j; ++i) {
      const double through = cost[i] + (points[j] - points[i]).norm();
      if (through < cost[j] - 1e-9 && blockers.free(points[i], points[j])) {
        cost[j] = through;
        from[j] = i;
      }
    }
  }
  Polyline chain = {points.back()};
  for (std::size_t j = n - 1; j > 0; j = from[j]) chain.push_back(points[from[j]]);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

// Without the points that lie on the straight line between their neighbours, to 1 nm of length.
Polyline without_collinear(const geom::CollisionScene& scene, const Polyline& path) {
  Polyline out = {path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec3& a = out.back();
    const Vec3& b = path[i + 1];
    const double detour = (path[i] - a).norm() + (b - path[i]).norm() - (b - a).norm();
    if (detour > 1e-9 || !scene.free(a, b)) out.push_back(path[i]);
  }
  out.push_back(path.back());
  return out;
}

}  // namespace

Polyline resample_free(const geom::CollisionScene& scene, const Polyline& path, double step) {
  Polyline out = {path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Polyline parts = geom::resample({path[i - 1], path[i]}, step);
    bool clear = true;
    for (std::size_t k = 1; k < parts.size() && clear; ++k)
      clear = scene.free(parts[k - 1], parts[k]);
    if (clear) {
      out.insert(out.end(), parts.begin() + 1, parts.end());
    } else {
      out.push_back(path[i]);
    }
  }
  return out;
}

Polyline shortcut(const geom::CollisionScene& scene, const Polyline& path, int rounds) {
  if (path.size() < 3) return path;
  Polyline best = shortest_chain(scene, path);
  for (int round = 0; round < rounds; ++round) {
    const double before = geom::length(best);
    best = without_collinear(
        scene, shortest_chain(scene, resample_free(scene, best, std::max(before / kPoints, 1e-3))));
    if (before - geom::length(best) < 1e-3) break;
  }
  return best;
}

}  // namespace plan
