#include "geom/zone/zones_crossed.h"

#include <algorithm>
#include <map>

#include "geom/base/error.h"

namespace geom {
namespace {

void require_within(const Aabb& bounds, std::span<const PlacedTime> flight,
                    const std::string& source) {
  for (const PlacedTime& part : flight) {
    if ((bounds.min.array() <= part.room.min.array()).all() &&
        (part.room.max.array() <= bounds.max.array()).all()) {
      continue;
    }
    throw InputError(source, {.says = "the flight leaves the bounds of the map, and zones are "
                                      "looked at only within them",
                              .advice = "widen the bounds (skyway-map bounds)"});
  }
}

}  // namespace

std::vector<CrossedZone> zones_crossed(const ZoneFile& file, const std::string& source,
                                       ZoneRoom room, std::span<const PlacedTime> flight) {
  require_within(room.spec.bounds, flight, source);
  room.types = {ZoneType::prohibited, ZoneType::authorization, ZoneType::conditional,
                ZoneType::u_space, ZoneType::none};
  const BoxTable table = zone_boxes(file, source, room).table;
  std::map<std::size_t, TimeSpan> found;
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    const TimeSpan there = table.time(i);
    for (const PlacedTime& part : flight) {
      if (!there.meets(part.time) || !overlap(table.boxes[i], part.room)) continue;
      const TimeSpan both{std::max(there.from, part.time.from),
                          std::min(there.until, part.time.until)};
      const auto [at, fresh] = found.try_emplace(table.ids[i], both);
      if (fresh) continue;
      at->second.from = std::min(at->second.from, both.from);
      at->second.until = std::max(at->second.until, both.until);
    }
  }
  std::vector<CrossedZone> out;
  for (const auto& [index, time] : found) out.push_back({index, time});
  return out;
}

}  // namespace geom
