#pragma once

// Certificates of lower bounds on length, as JSON Lines records that anyone can follow.
//
// Example:
//   plan::BoundRecord record{.id = "q1", .from = {1, 1, 1}, .to = {9, 1, 1}};
//   record.bound = 8;  // with an empty proof: the straight line
//   record.bounds = map.spec().bounds;
//   record.provenance = geom::provenance_of(scene);
//   std::cout << to_json_line(record);
//
// docs/certificates.md says how.

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
