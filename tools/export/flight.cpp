#include "flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "traj/record/trajectory_record.h"

namespace exporting {
namespace {

using geom::Vec3;

double stands_still(const traj::Trajectory& trajectory) {
  double seconds = 0;
  for (const traj::Segment& s : trajectory.segments) {
    const auto here = [&](const Vec3& p) { return p == s.point.front(); };
    if (std::all_of(s.point.begin(), s.point.end(), here)) seconds += s.duration;
  }
  return seconds;
}

Flight flight_of(traj::TrajectoryRecord record) {
  Flight flight;
  flight.id = record.id;
  flight.provenance = record.provenance;
  flight.limits = record.limits;
  flight.time = record.time;
  if (record.status != traj::TrajectoryStatus::solved) {
    flight.missing = fmt::format("the record holds no trajectory (status {})", name(record.status));
  }
  flight.trajectory = std::move(record.trajectory);
  flight.holds = stands_still(flight.trajectory);
  return flight;
}

traj::Segment straight(const Vec3& from, const Vec3& to) {
  traj::Segment segment{1, {}, {}};
  for (std::size_t i = 0; i < traj::kPoints; ++i) {
    segment.point[i] = from + (to - from) * (static_cast<double>(i) / traj::kDegree);
  }
  segment.point.back() = to;
  return segment;
}

Flight flight_of(geom::PathRecord record) {
  Flight flight;
  flight.id = record.id;
  flight.provenance = record.provenance;
  flight.time = record.time;
  if (record.status != geom::PathStatus::found) {
    flight.missing = fmt::format("the record holds no path (status {})", name(record.status));
  }
  flight.path = std::move(record.points);
  flight.path.erase(std::unique(flight.path.begin(), flight.path.end()), flight.path.end());
  for (std::size_t i = 1; i < flight.path.size(); ++i) {
    flight.trajectory.segments.push_back(straight(flight.path[i - 1], flight.path[i]));
  }
  if (flight.path.size() == 1) {
    flight.trajectory.segments.push_back(straight(flight.path[0], flight.path[0]));
  }
  flight.holds = std::accumulate(record.hold.begin(), record.hold.end(), 0.0);
  flight.has_velocities = std::any_of(record.velocity.begin(), record.velocity.end(),
                                      [](const auto& v) { return v && *v != Vec3::Zero(); });
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
    if (!id.empty() && flight.id != id) return;
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
