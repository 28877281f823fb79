#pragma once

// The page of a folder: its map and flights, as skyway-view shows them.

#include <string>
#include <vector>

#include "cli/run.h"
#include "traj/mission/formats/placement.h"
#include "traj/submit/submission.h"

namespace submitting {

// Of these files, which are read again. `placement`: of missions.
std::string view_page(const cli::Common& common, const std::vector<std::string>& files,
                      const traj::SubmissionMethod& method, const traj::Placement& placement,
                      const std::string& title);

}  // namespace submitting
