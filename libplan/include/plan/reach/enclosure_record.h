#pragma once

// Why there is no way, as a JSON Lines record that anyone can follow: docs/certificates.md.

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
