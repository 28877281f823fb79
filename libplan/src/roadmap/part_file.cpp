#include "plan/roadmap/part_file.h"

#include "geom/text/json_fields.h"
#include "roadmap_arrays.h"

namespace plan {

PartArrays arrays_of(const Roadmap& part) {
  const auto tiles = std::make_shared<const TileArrays>(std::span(&part, 1));
  PartArrays out;
  out.meta = roadmap_meta(part).object();
  tiles->append_to(out.arrays);
  out.keep_alive = tiles;
  return out;
}

Roadmap read_roadmap_part(const geom::ArrayArchive& archive, std::string_view meta_json) {
  const geom::JsonFields fields(meta_json, archive.name(), 0);
  const RoadmapSpec spec = read_roadmap_spec(fields);
  Roadmap out = open_tiles(archive);
  out.spec = spec;
  out.made_for = geom::read_provenance(fields);
  return out;
}

}  // namespace plan
