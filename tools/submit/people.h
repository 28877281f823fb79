#pragma once

// --population: the people below the flights of a folder.

#include <string>

#include "flight_files.h"
#include "submission_folder.h"
#include "traj/submit/submission.h"

namespace submitting {

// Adds population.csv, with all cells that the ground risk buffers may touch, and the number of
// people to the flights' claims. Throws geom::InputError where the raster does not reach as far as
// a buffer, and std::runtime_error where this build, or this machine, has no GDAL.
void count_people(const std::string& path, FlightFiles& flights, traj::Submission& submission,
                  SubmissionFolder& folder);

}  // namespace submitting
