#pragma once

// --tube: the proved tubes of the trajectories of a folder.

#include <optional>
#include <string>

#include "submission_folder.h"
#include "traj/record/tube_reports.h"
#include "traj/submit/submission.h"

namespace submitting {

// Copies the reports of a file into the folder, and names the file in the method. Nothing where no
// file is asked for.
std::optional<traj::TubeReports> take_tubes(const std::string& path, traj::SubmissionMethod& method,
                                            SubmissionFolder& folder);

}  // namespace submitting
