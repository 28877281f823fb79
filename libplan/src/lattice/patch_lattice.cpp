#include "plan/lattice/patch_lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "block_store.h"
#include "geom/base/error.h"
#include "patch/require_made_for.h"
#include "plan/lattice/build_lattice.h"

namespace plan {
namespace {

using geom::Aabb;

// Marks the blocks with a node, or the end of an edge of one, in the box; and some beside them, so
// that rounding does not matter.
void mark(const LatticeGrid& grid, const Aabb& box, std::vector<char>& changed) {
  constexpr double kSlack = 2;  // nodes
  const Index3 n = grid.blocks();
  Index3 first;
  Index3 last;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const auto block_at = [&](double x, double beyond) {
      const double node = (x - grid.spec.origin[axis]) / grid.spec.spacing -
                          static_cast<double>(grid.first[k]) + beyond;
      const double block = std::floor(node / LatticeGrid::kSide);
      return static_cast<std::int64_t>(std::clamp(block, -1.0, static_cast<double>(n[k])));
    };
    // A block's edges end at most one node beyond its 8.
    first[k] = std::max<std::int64_t>(block_at(box.min[axis], -1 - kSlack), 0);
    last[k] = std::min(block_at(box.max[axis], 1 + kSlack), n[k] - 1);
  }
  for (std::int64_t z = first[2]; z <= last[2]; ++z) {
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      for (std::int64_t x = first[0]; x <= last[0]; ++x) {
        changed[static_cast<std::size_t>(x + n[0] * (y + n[1] * z))] = 1;
      }
    }
  }
}

}  // namespace

Lattice patch_lattice(const Lattice& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run,
                      const std::optional<Aabb>& within) {
  require_made_for(old.made_for(), scene, "lattice");
  const auto* store = dynamic_cast<const BlockStore*>(&old.source());
  if (!store) throw std::logic_error("only a lattice that was built can be patched");
  const Lattice anew = lazy_lattice(scene, old.spec(), within);
  if (anew.first() != old.first() || anew.dims() != old.dims()) {
    throw geom::InputError(
        "lattice",
        {.expected = fmt::format("the nodes that the bounds of the new map hold, {} x {} x {}",
                                 anew.dims()[0], anew.dims()[1], anew.dims()[2]),
         .found = fmt::format("{} x {} x {}", old.dims()[0], old.dims()[1], old.dims()[2]),
         .advice = "build it anew, without --patch"});
  }
  OldBlocks kept{*store, std::vector<char>(old.grid().block_count())};
  for (const auto* boxes : {&change.removed, &change.added}) {
    for (const Aabb& box : *boxes) mark(old.grid(), box, kept.changed);
  }
  return Lattice(anew.grid(), anew.made_for(),
                 store_blocks(anew.grid(), anew.source(), run, &kept));
}

}  // namespace plan
