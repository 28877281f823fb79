#pragma once

// A shard of a roadmap: what one of several processes builds.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/shard.h"
#include "geom/collision/collision.h"
#include "plan/lattice/lattice_part.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// Edges of all bends one after the other.
struct EdgeLists {
  std::span<const std::uint64_t> first;  // those of bend i begin there; one more than bends
  std::span<const std::uint32_t> to;
  std::shared_ptr<const void> keep_alive;  // of the spans

  std::span<const std::uint32_t> of(std::size_t bend) const {
    return to.subspan(first[bend], first[bend + 1] - first[bend]);
  }
};

// Each list is freed once it was copied.
EdgeLists flat(std::vector<std::vector<std::uint32_t>> lists);

// The bends around a run of boxes, and their edges to all later bends. Boxes are counted in the
// order in which the roadmap goes round them.
struct RoadmapPart {
  RoadmapSpec spec;
  geom::Provenance made_for;
  geom::Shard shard;
  std::size_t boxes = 0;                  // of all shards
  std::vector<Bend> bends;                // around the shard's boxes, in their order
  std::vector<std::uint32_t> bends_of;    // how many around each of them
  std::vector<std::uint32_t> near_box;    // boxes of later shards that are within reach, ascending
  std::vector<std::uint32_t> near_bends;  // how many bends around each of those
  EdgeLists edges;  // of each bend, ascending: the shard's bends are numbered first, then those of
                    // the near boxes
  std::optional<LatticePart> coarse;  // of Roadmap::coarse
};

// The shard's part of what build_roadmap() gives; only boxes within reach of its own are looked at.
RoadmapPart build_roadmap_part(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                               const geom::Shard& shard, const geom::Execution& run = {});

// The roadmap of all its parts, in the order of their shards: bit for bit what build_roadmap()
// gives. Throws geom::InputError where they are not the parts of one roadmap, or have too many
// edges. Holds the edges of the roadmap once, and what the parts hold.
Roadmap join_roadmap(std::span<const RoadmapPart> parts, const geom::Execution& run = {});

}  // namespace plan
