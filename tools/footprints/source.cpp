#include "footprints/source.h"

namespace footprints {

geom::BuildingHeight counted_height(const std::function<std::string(const char*)>& tag,
                                    const ReadOptions& options, Source& source) {
  const geom::BuildingHeight height = geom::building_height(tag, options.height);
  switch (height.from) {
    case geom::HeightFrom::height:
      ++source.counts["heights_given"];
      break;
    case geom::HeightFrom::levels:
      ++source.counts["heights_from_levels"];
      break;
    case geom::HeightFrom::nothing:
      ++source.counts["heights_by_default"];
      break;
  }
  if (height.junk) ++source.counts["heights_not_understood"];
  return height;
}

}  // namespace footprints
