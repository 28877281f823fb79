#include "plan/sampling/tree_parts.h"

#include <array>
#include <cstdint>
#include <utility>

namespace plan {
namespace {

constexpr std::array<std::uint8_t, 3> kTrees[] = {{86, 140, 196}, {204, 102, 85}};

}  // namespace

std::vector<geom::MeshPart> tree_parts(const SearchTreeRecord& record, geom::Axes axes,
                                       double radius) {
  std::vector<geom::MeshPart> parts;
  for (std::uint8_t which = 0; which < 2; ++which) {
    geom::Rods rods{"tree " + record.id + (which ? " from the goal" : " from the start"),
                    kTrees[which],
                    {},
                    {},
                    radius,
                    2 * radius};
    std::vector<std::uint32_t> place(record.tree.points.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (record.tree.tree[i] != which) continue;
      place[i] = static_cast<std::uint32_t>(rods.points.size());
      rods.points.push_back(geom::to_enu(axes, record.tree.points[i]));
    }
    for (std::size_t i = 0; i < place.size(); ++i) {
      const std::uint32_t parent = record.tree.parent[i];
      if (record.tree.tree[i] != which || parent == i) continue;
      rods.edges.push_back({place[parent], place[i]});
    }
    if (!rods.points.empty()) parts.push_back(geom::rod_part(std::move(rods)));
  }
  return parts;
}

}  // namespace plan
