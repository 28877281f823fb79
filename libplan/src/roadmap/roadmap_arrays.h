#pragma once

// What files of whole roadmaps and of shards of them have in common.

#include <span>
#include <vector>

#include "geom/archive/array_archive.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// The arrays of all the tiles of several roadmaps, which they refer to: one after the other.
class TileArrays {
 public:
  // Throws geom::InputError where tiles do not ascend, or their ranges are impossible.
  explicit TileArrays(std::span<const Roadmap> parts);
  void append_to(std::vector<geom::NamedArray>& arrays) const;  // which refer to this

  std::size_t bends() const { return first_.back(); }
  std::size_t edges() const { return edges_.back(); }  // counted from both ends

 private:
  std::span<const Roadmap> parts_;
  std::vector<std::uint64_t> first_{0};
  std::vector<std::uint64_t> edges_{0};
};

// Opens them. Throws geom::InputError for arrays of lengths that do not fit each other.
Roadmap open_tiles(const geom::ArrayArchive& archive);

// meta.json as far as the spec goes.
geom::JsonLine roadmap_meta(const Roadmap& roadmap);

// The same read; refuses other formats and versions.
RoadmapSpec read_roadmap_spec(const geom::JsonFields& fields);

}  // namespace plan
