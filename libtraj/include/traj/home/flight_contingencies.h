#pragma once

// Flights of a stream of records held against their planned ways home.
//
// Example:
//   std::istringstream in(traj::to_json_line(traj::ContingencyRecord{.id = "q1", .until = 5}));
//   const traj::FlightContingencies ways(in, "ways.jsonl", {});
//   traj::HomeFlight flight{.id = "q1"};
//   flight.stages = traj::stages_of(trajectory);
//   assert(!ways.check(scene, flight, {.exact = true}).report.result.ok);  // no way was found

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/home/check_contingencies.h"
#include "traj/home/home_flight.h"
#include "traj/record/report_record.h"

namespace traj {

// How ways home are proved, beyond check_contingencies().
struct ContingencyProof {
  bool exact = false;        // once more in exact numbers
  bool certificate = false;  // the same, and a line that says why they hold
};

struct CheckedContingencies {
  ReportRecord report;
  std::string certificate = {};  // empty where nothing holds, or nobody asked
};

// Throws InputError(source, line, …) for a way home of a flight with another id, or of another one
// with this id (require_of_flight()).
void require_of(const HomeFlight& flight, const ContingencyRecord& way, std::string_view source,
                std::size_t line);

class FlightContingencies {
 public:
  // Reads contingencies to the end of the stream. Throws InputError(source, line, …) as
  // parse_contingency_record().
  FlightContingencies(std::istream& in, std::string source, ContingencyRules rules);

  // The largest margin of the flight, its contingencies and the autopilots. Throws InputError where
  // these are not all of one map, or are of another flight with this id.
  geom::Provenance room_of(const HomeFlight& flight) const;

  // In the scene of room_of(). Threads may call at once.
  CheckedContingencies check(const geom::CollisionScene& scene, const HomeFlight& flight,
                             const ContingencyProof& proof) const;

  // Throws InputError for contingencies of a flight that is not among these.
  void require_used(const std::set<std::string>& flights) const;

 private:
  const std::vector<ContingencyRecord>& records_of(const HomeFlight& flight) const;

  std::string source_;
  std::map<std::string, std::vector<ContingencyRecord>> records_;
  ContingencyRules rules_;
};

}  // namespace traj
