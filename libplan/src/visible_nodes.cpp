#include "plan/visible_nodes.h"

#include <algorithm>
#include <cmath>

namespace plan {
namespace {

constexpr std::int64_t kRings = 4;  // around the innermost

}  // namespace

std::vector<Terminal> visible_nodes(const geom::CollisionScene& scene, const Lattice& lattice,
                                    AstarSearch& search, const Vec3& p, Rings rings) {
  Index3 base;
  for (int k = 0; k < 3; ++k) {
    const double cells = std::floor((p[k] - lattice.coordinate(k, 0)) / lattice.spec().spacing);
    base[k] = std::clamp(static_cast<std::int64_t>(cells), std::int64_t{-1}, lattice.dims()[k]);
  }
  std::vector<Terminal> found;
  for (std::int64_t ring = 0; ring <= kRings; ++ring) {
    if (rings == Rings::nearest && !found.empty()) break;
    for (std::int64_t k = -ring; k <= ring + 1; ++k) {
      for (std::int64_t j = -ring; j <= ring + 1; ++j) {
        for (std::int64_t i = -ring; i <= ring + 1; ++i) {
          const auto on_edge = [&](std::int64_t v) { return v == -ring || v == ring + 1; };
          if (!on_edge(i) && !on_edge(j) && !on_edge(k)) continue;
          const Index3 index = {base[0] + i, base[1] + j, base[2] + k};
          const auto node = lattice.node(index);
          if (!node || !search.free(index)) continue;
          const Vec3 q = lattice.position(*node);
          if (scene.free(p, q)) found.push_back({*node, (q - p).norm()});
        }
      }
    }
  }
  return found;
}

}  // namespace plan
