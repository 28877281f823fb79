#pragma once

// Certificates that there is no way, as JSON Lines records that anyone can follow.
//
// Example:
//   plan::EnclosureRecord record{.id = "q1", .from = {1, 1, 1}, .to = {9, 1, 1}};
//   record.enclosure.cells = {{{0, 0, 0}, {2, 2, 2}}};  // all that can be reached from the start
//   record.bounds = map.spec().bounds;
//   record.provenance = geom::provenance_of(scene);
//   std::cout << to_json_line(record);
//
// docs/certificates.md says how.

#include <string>

#include "geom/record/record.h"
#include "plan/reach/reach.h"

namespace plan {

struct EnclosureRecord {
  std::string id;
  Vec3 from;  // as searched: where snapping moved an end to, there
  Vec3 to;
  Enclosure enclosure;
  geom::Aabb bounds;  // the map's
  geom::Provenance provenance;
};

std::string to_json_line(const EnclosureRecord& record);  // ends with a newline

}  // namespace plan
