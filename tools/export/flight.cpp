#include "flight.h"

#include <fmt/format.h>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "traj/record/trajectory_record.h"

namespace exporting {
namespace {

std::string missing(std::string_view what, std::string_view status, const std::string& why) {
  return fmt::format("the record holds no {} (status {}){}", what, status,
                     why.empty() ? "" : ": " + why);
}

Flight flight_of(const traj::TrajectoryRecord& record) {
  Flight flight{traj::export_flight(record), "", record.provenance};
  if (record.status != traj::TrajectoryStatus::solved) {
    flight.missing = missing("trajectory", name(record.status), record.message);
  }
  return flight;
}

Flight flight_of(const geom::PathRecord& record) {
  Flight flight{traj::export_flight(record), "", record.provenance};
  if (record.status != geom::PathStatus::found) {
    flight.missing = missing("path", name(record.status), record.message);
  }
  return flight;
}

Flight parse(const std::string& line, const std::string& source, std::size_t number) {
  const geom::JsonFields fields(line, source, number);
  return fields.text("type") == "path" ? flight_of(geom::read_path_record(fields))
                                       : flight_of(traj::read_trajectory_record(fields));
}

}  // namespace

std::vector<Flight> read_flights(const std::string& input, const std::string& id, bool each) {
  cli::InputFile file(input);
  std::vector<Flight> flights;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    Flight flight = parse(line, file.name(), number);
    if (!id.empty() && flight.way.id != id) return;
    if (!flights.empty() && (!each || !id.empty())) {
      geom::Fault fault{.expected = "one trajectory or path", .found = "another"};
      if (id.empty()) {
        fault.advice = "choose one with --id, or write a file for each with -o '%s.csv'";
      } else {
        fault.expected += fmt::format(" of id \"{}\"", id);
      }
      throw geom::InputError(file.name(), number, std::move(fault));
    }
    flights.push_back(std::move(flight));
  });
  if (flights.empty()) {
    throw geom::InputError(
        file.name(),
        {.expected = fmt::format("a trajectory or path of id \"{}\"", id), .found = "none"});
  }
  return flights;
}

}  // namespace exporting
