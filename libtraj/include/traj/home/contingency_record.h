#pragma once

// Ways home as JSON Lines records.
//
// Example:
//   traj::ContingencyRecord record{.id = "q1", .from = 0, .until = 12.5};
//   record.site = "pad-2";
//   record.points = {{1, 1, 9}, {1, 1, 5}, {1, 1, 0}};
//   record.provenance = geom::provenance_of(scene);
//   const std::string line = traj::to_json_line(record);
//   const auto back = traj::parse_contingency_record(line, "home.jsonl", 1);
//   assert(back.points == record.points && back.until == 12.5);

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/record/record.h"
#include "traj/home/ways_home.h"

namespace traj {

struct ContingencyRecord {
  std::string id;              // of the flight
  double from = 0;             // s of the flight, closed
  double until = 0;            // s, not before `from`
  std::string site = {};       // where it lands
  geom::Polyline points = {};  // WayHome::points; empty: no way was found from these instants
  std::optional<double> length = {};    // m, as in WayHome
  std::optional<double> duration = {};  // s
  bool bounds_energy = false;           // whether there is an energy for what follows
  std::optional<double> latest_departure = {};
  std::string autopilot = {};  // those that may brake, as reports name them
  std::string message = {};    // why there is no way, in words; may be empty
  // checked_hash() of the flight (traj/record/checked_hash.h); empty: the record does not say it.
  std::string flight_hash = {};
  geom::Provenance provenance = {};

  bool found() const { return !points.empty(); }

  // The last instant, s of the flight, up to which the way is good for: `until` if nothing is known
  // of energy. Nothing if there is no way, or never the energy for it.
  std::optional<double> good_until() const {
    if (!found()) return std::nullopt;
    return bounds_energy ? latest_departure : until;
  }
};

std::string to_json_line(const ContingencyRecord& record);  // ends with a newline

// Throws InputError(source, line, …) for anything that is not such a record: malformed JSON, a
// missing key, a number that is not finite, an `until` before `from`, a way of fewer than two
// points or without a site.
ContingencyRecord parse_contingency_record(std::string_view json, std::string_view source,
                                           std::size_t line);

// One for each way and gap of a flight with this checked_hash(), ascending in time.
std::vector<ContingencyRecord> contingency_records(const std::string& id, const WaysHome& home,
                                                   const WaysTask& task,
                                                   const geom::Provenance& provenance,
                                                   const std::string& flight_hash = {});

// Throws InputError(source, line, …) where a way home, or a report of some, is of another flight
// with its id: its `flight_hash` is none of those of the `flights` of this id. An empty hash is
// that of any flight, and no flights may be any.
void require_of_flight(std::string_view id, std::string_view flight_hash,
                       const std::vector<std::string>& flights, std::string_view source,
                       std::size_t line);

}  // namespace traj
