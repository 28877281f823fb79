#pragma once

// What is to be exported.

#include <string>
#include <vector>

#include "geom/record/record.h"
#include "traj/mission/formats/export_flight.h"

namespace exporting {

// A trajectory record or a path record.
struct Flight {
  traj::ExportFlight way;
  std::string missing;  // why there is nothing to fly; empty otherwise
  geom::Provenance provenance;
};

// The records of the stream, or those of one id. Two flights do not fit one drone file, so there is
// one, unless there is a file for each (`each`). Throws InputError where there are others, or none.
std::vector<Flight> read_flights(const std::string& input, const std::string& id, bool each);

}  // namespace exporting
