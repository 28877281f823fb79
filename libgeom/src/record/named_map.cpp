#include "geom/record/named_map.h"

#include "geom/map/always_there.h"

namespace geom {

bool NamedMap::is_of_always_there(const Provenance& record) {
  if (map_.timed().empty() || !record.map || *record.map == map_.hash()) return false;
  if (!always_there_) always_there_ = always_there(map_).hash();
  return *record.map == *always_there_;
}

void NamedMap::require(const Provenance& record, std::string_view source, std::size_t line) {
  Provenance ours;
  ours.map = map_.hash();
  ours.frame = map_.spec().frame.axes;
  if (is_of_always_there(record)) ours.map = always_there_;
  require_map_agrees(record, ours, source, line);
}

}  // namespace geom
