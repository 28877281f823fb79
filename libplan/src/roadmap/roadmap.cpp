#include "plan/roadmap/roadmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "bends.h"
#include "geom/base/error.h"
#include "plan/lattice/build_lattice.h"

namespace plan {

void require_bend(const Roadmap& roadmap, std::uint32_t bend) {
  if (bend < roadmap.bends.size()) return;
  throw geom::InputError(roadmap.source,
                         fmt::format("an edge leads to bend {} of {}", bend, roadmap.bends.size()));
}

Roadmap bends_along(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                    const geom::Polyline& path, double width) {
  constexpr double kPiece = 50;  // metres: bounding boxes of longer ones would hold too much
  Roadmap out;
  out.spec = spec;
  out.made_for = geom::provenance_of(scene);
  std::vector<std::size_t> near;
  const geom::Polyline pieces = geom::resample(path, kPiece);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const geom::Aabb piece{pieces[i - 1].cwiseMin(pieces[i]), pieces[i - 1].cwiseMax(pieces[i])};
    for (const std::size_t box : scene.boxes_meeting(geom::grow(piece, Vec3::Constant(width)))) {
      near.push_back(box);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<geom::Aabb> boxes;
  for (const std::size_t i : near) boxes.push_back(scene.grown(i));
  out.bends = make_bends(scene, spec, boxes, {});
  return out;
}

LabelledLattice label_components(Lattice lattice) {
  const LatticeGrid& grid = lattice.grid();
  std::vector<std::uint32_t> masks(lattice.size());
  Lattice::Block block;
  for (std::size_t b = 0; b < grid.block_count(); ++b) {
    lattice.read(b, block);
    const Index3 low = grid.block_low(b);
    for (std::size_t n = 0; n < block.size(); ++n) {
      const auto local = static_cast<std::int64_t>(n);
      const auto node = lattice.node({low[0] + local % LatticeGrid::kSide,
                                      low[1] + local / LatticeGrid::kSide % LatticeGrid::kSide,
                                      low[2] + local / (LatticeGrid::kSide * LatticeGrid::kSide)});
      if (node) masks[*node] = block[n];
    }
  }
  std::vector<std::uint32_t> label(masks.size());
  std::uint32_t labels = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < masks.size(); ++start) {
    if (!(masks[start] & Lattice::kNode) || label[start]) continue;
    label[start] = ++labels;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t from = open.back();
      open.pop_back();
      for (std::uint32_t m = masks[from] & ~Lattice::kNode; m; m &= m - 1) {
        const auto to = static_cast<std::size_t>(static_cast<std::int64_t>(from) +
                                                 lattice.offset(std::countr_zero(m)));
        if (label[to]) continue;
        label[to] = labels;
        open.push_back(to);
      }
    }
  }
  return {std::move(lattice), std::move(label)};
}

}  // namespace plan
