#include "plan/lattice/visible_nodes.h"

#include "ring.h"

namespace plan {
namespace {

constexpr std::int64_t kRings = 4;  // around the innermost

}  // namespace

std::vector<Terminal> visible_nodes(const geom::CollisionScene& scene, const Lattice& lattice,
                                    AstarSearch& search, const Vec3& p, Rings rings) {
  std::vector<Terminal> found;
  for (std::int64_t ring = 0; ring <= kRings; ++ring) {
    if (rings == Rings::nearest && !found.empty()) break;
    any_in_ring(lattice, p, ring, [&](const Index3& index) {
      if (!search.free(index)) return false;
      const std::size_t node = *lattice.node(index);
      const Vec3 q = lattice.position(node);
      if (scene.free(p, q)) found.push_back({node, (q - p).norm()});
      return false;
    });
  }
  return found;
}

}  // namespace plan
