#pragma once

// The arrays of a roadmap that is in memory.

#include <memory>
#include <span>
#include <vector>

#include "geom/base/rounding.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

struct OwnedTiles {
  std::vector<std::int32_t> tile_index;
  std::vector<float> tile_extent;
  std::vector<std::uint64_t> tile_first{0};
  std::vector<std::uint64_t> tile_edges{0};
  std::vector<double> bend_position;
  std::vector<std::int8_t> bend_axis;
  std::vector<std::int8_t> bend_outward;
  std::vector<std::uint32_t> edge_first;
  std::vector<std::uint32_t> edge_split;
  std::vector<std::uint32_t> edge_to;

  void add(const Bend& bend) {
    bend_position.insert(bend_position.end(), bend.position.begin(), bend.position.end());
    bend_axis.push_back(bend.axis);
    bend_outward.insert(bend_outward.end(), bend.outward.begin(), bend.outward.end());
  }

  // Of a tile with these bends, of which there is one at least.
  void add_extent(std::span<const Bend> bends) {
    Vec3 low = bends[0].position;
    Vec3 high = low;
    for (const Bend& bend : bends) {
      low = low.cwiseMin(bend.position);
      high = high.cwiseMax(bend.position);
    }
    for (int k = 0; k < 3; ++k) tile_extent.push_back(geom::float_down(low[k]));
    for (int k = 0; k < 3; ++k) tile_extent.push_back(geom::float_up(high[k]));
  }
};

inline Roadmap roadmap_of(const RoadmapSpec& spec, const std::shared_ptr<const OwnedTiles>& owned) {
  Roadmap out;
  out.spec = spec;
  out.tile_index = owned->tile_index;
  out.tile_extent = owned->tile_extent;
  out.tile_first = owned->tile_first;
  out.tile_edges = owned->tile_edges;
  out.bend_position = owned->bend_position;
  out.bend_axis = owned->bend_axis;
  out.bend_outward = owned->bend_outward;
  out.edge_first = owned->edge_first;
  out.edge_split = owned->edge_split;
  out.edge_to = owned->edge_to;
  out.keep_alive = owned;
  return out;
}

}  // namespace plan
