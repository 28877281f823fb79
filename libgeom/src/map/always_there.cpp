#include "geom/map/always_there.h"

#include "geom/map/join.h"

namespace geom {

BoxMap always_there(const BoxMap& map) {
  if (map.timed().empty()) return map;
  BoxTable table = table_of(map);
  table.keep_if([&](std::size_t i) { return map.time(i).always(); });
  return {map.spec(), table};
}

}  // namespace geom
