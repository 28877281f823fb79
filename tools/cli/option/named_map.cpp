#include "named_map.h"

#include "geom/map/always_there.h"

namespace cli {

bool NamedMap::is_of_always_there(const geom::Provenance& record) {
  if (map_.timed().empty() || !record.map || *record.map == map_.hash()) return false;
  if (!always_there_) always_there_ = geom::always_there(map_).hash();
  return *record.map == *always_there_;
}

void NamedMap::require(const geom::Provenance& record, std::string_view source, std::size_t line) {
  geom::Provenance ours;
  ours.map = map_.hash();
  ours.frame = map_.spec().frame.axes;
  if (is_of_always_there(record)) ours.map = always_there_;
  geom::require_map_agrees(record, ours, source, line);
}

}  // namespace cli
