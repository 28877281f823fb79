#pragma once

// The page of a folder: its map and flights, as skyway-view shows them.

#include <string>
#include <vector>

#include "cli/run.h"
#include "traj/submit/submitted_flights.h"

namespace submitting {

// Of these files, which are read again, missions as `flights` reads them.
std::string view_page(const cli::Common& common, const std::vector<std::string>& files,
                      const traj::SubmittedFlights& flights, const std::string& title);

}  // namespace submitting
