#pragma once

// What the check found, as a JSON Lines record.

#include <optional>
#include <string>

#include "geom/box_map.h"
#include "geom/io/record.h"
#include "traj/check.h"
#include "traj/exact_check.h"

namespace traj {

struct ReportRecord {
  std::string id;
  std::string checked;  // "trajectory" or "path"
  CheckResult result;   // a record that holds nothing to check has only `reason`
  geom::Provenance provenance;
  Limits limits;
  std::optional<ExactResult> exact;  // where it was asked for
};

// Whether every check that was made accepts it.
bool accepted(const ReportRecord& record);

// Ends with a newline. `map` gives the source id of the obstacle that was hit.
std::string to_json_line(const ReportRecord& record, const geom::BoxMap& map);

}  // namespace traj
