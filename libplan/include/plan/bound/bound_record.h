#pragma once

// Why no path is shorter than its bound, as a JSON Lines record that anyone can follow:
// docs/certificates.md.

#include <string>

#include "geom/record/record.h"
#include "plan/bound/length_proof.h"

namespace plan {

struct BoundRecord {
  std::string id;
  geom::Vec3 from;  // as searched: where snapping moved an end to, there
  geom::Vec3 to;
  double bound = 0;  // metres
  LengthProof proof;
  geom::Aabb bounds;  // the map's
  geom::Provenance provenance;
};

std::string to_json_line(const BoundRecord& record);  // ends with a newline

}  // namespace plan
