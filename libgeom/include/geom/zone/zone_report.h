#pragma once

// What a map's history says of the zones that were closed in it.
//
// Example:
//   for (const geom::ZoneSource& source : geom::zone_sources(map.spec())) {
//     std::cout << source.file << ' ' << source.issued << ' ' << source.hash << '\n';
//     for (const geom::ListedZone& zone : source.zones) std::cout << zone.identifier << '\n';
//   }

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/zone/zone_boxes.h"

namespace geom {

// A zone over or under the bounds of the map when it was patched.
struct ListedZone {
  std::string identifier;
  std::string name;
  ZoneType type = ZoneType::prohibited;
  std::size_t boxes = 0;        // that it became; 0: it is not closed in the map
  std::vector<TimeSpan> times;  // seconds after the map's epoch, rounded outward
  std::string authority;
  std::string message;
};

// A file of zones, as the map's history keeps it.
struct ZoneSource {
  std::string file;  // its name, without folders
  std::string hash;  // "sha256:…"
  std::string format;
  std::string title;
  std::string issued;    // as the file has it; may be empty
  std::string valid_to;  // may be empty
  std::size_t zones_read = 0;
  std::vector<ListedZone> zones;
};

// The listed zones of a file.
ZoneSource zone_source(const ZoneFile& file, const ZoneBoxes& boxes);

// As JSON, for a step of a history.
nlohmann::ordered_json to_json(const ZoneSource& source);

// All of a map's history, with those of maps that were joined. A source is left out if boxes were
// removed after it (skyway-map patch --remove), because these may be boxes of its zones. Throws
// InputError("the map's history", …) where it is not as to_json() writes it.
std::vector<ZoneSource> zone_sources(const BoxMapSpec& spec);

}  // namespace geom
