#include "tree_path.h"

#include <algorithm>

#include "path/shortcut.h"
#include "plan/sampling/rrt.h"

namespace plan {
namespace {

constexpr std::uint64_t kTrees = 4;
constexpr std::size_t kIterations = 500;  // of each pair of trees
constexpr double kLeast = 100;            // metres around the places, at least
constexpr double kShare = 1;              // of their distance

}  // namespace

geom::Polyline tree_path(const geom::CollisionScene& scene, const geom::Vec3& from,
                         const geom::Vec3& to) {
  const double around = std::max(kLeast, kShare * (to - from).norm());
  SamplingOptions options;
  options.iterations = kIterations;
  options.straight_first = false;
  options.region =
      geom::grow(geom::Aabb{from.cwiseMin(to), from.cwiseMax(to)}, geom::Vec3::Constant(around));
  geom::Polyline best;
  for (std::uint64_t seed = 0; seed < kTrees; ++seed) {
    options.seed = seed;
    const auto found = sample_path(scene, from, to, SamplingMethod::rrt_connect, options);
    if (!found.found) continue;
    geom::Polyline path = shortcut(scene, found.path, 0);
    if (best.empty() || geom::length(path) < geom::length(best)) best = std::move(path);
  }
  return best;
}

}  // namespace plan
