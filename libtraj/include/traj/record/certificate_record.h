#pragma once

// Why a trajectory or path is clear and within its limits, as a JSON Lines record.

#include <optional>
#include <string>
#include <vector>

#include "geom/record/record.h"
#include "traj/proof/exact/exact_check.h"

namespace traj {

struct CertificateRecord {
  std::string id;
  std::string of;     // "trajectory" or "path"
  ExactResult proof;  // with ok
  geom::Aabb bounds;  // the map's
  geom::Provenance provenance;
  Limits limits;
  std::vector<std::string> overridden;  // as of the report
  // Where boxes that are there for a time were looked at by time: the map's epoch, and when the
  // flight begins after it.
  std::optional<std::string> epoch = {};
  std::optional<double> start = {};
  bool stands = false;  // before and after it, too
};

std::string to_json_line(const CertificateRecord& record);  // ends with a newline

}  // namespace traj
