#pragma once

// What files of whole roadmaps and of shards of them have in common.

#include <vector>

#include "geom/archive/array_archive.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// Bends as the arrays bend_position, bend_axis and bend_outward.
class BendArrays {
 public:
  explicit BendArrays(const std::vector<Bend>& bends);
  void append_to(std::vector<geom::NamedArray>& arrays) const;  // which refer to this

 private:
  std::vector<double> position_;
  std::vector<std::int8_t> axis_;
  std::vector<std::int8_t> outward_;
};

// Throws geom::InputError for arrays that do not fit, and a position, axis or sign that is none.
std::vector<Bend> read_bends(const geom::ArrayArchive& archive);

// meta.json as far as the spec goes.
geom::JsonLine roadmap_meta(const RoadmapSpec& spec, const geom::Provenance& made_for);

// The same read; refuses other formats and versions.
RoadmapSpec read_roadmap_spec(const geom::JsonFields& fields);

}  // namespace plan
