#include "source.h"

namespace footprints {

geom::BuildingHeight counted_height(const std::function<std::string(const char*)>& tag,
                                    const geom::HeightOptions& options, const std::string& which,
                                    Source& source) {
  const geom::BuildingHeight height = geom::building_height(tag, options);
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
  if (height.unread) source.skipped.add("height that is not understood", which);
  return height;
}

}  // namespace footprints
