#pragma once

// What was chosen for a stream, as records and as a report.
//
// No example: tools/fleet/main.cpp shows the order of the calls of traj/schedule.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/text/json_line.h"
#include "traj/fleet/departures.h"
#include "traj/schedule/fleet_obstacles.h"
#include "traj/schedule/fleet_stream.h"
#include "traj/together/check_together.h"

namespace traj {

// What a schedule is made of. All must outlive it.
struct ScheduleParts {
  const FleetStream& stream;
  const FleetObstacles& obstacles;
  std::span<const FleetFlight> flights;
  const FleetConflicts& conflicts;
  const Departures& departures;
};

// That all that departs keeps apart.
struct FleetProof {
  TogetherResult together;  // refused: pairs of two that are settled, and no others
  std::optional<MovingSummary> moving;
};

// What becomes of records that do not depart.
enum class Refused { kept, left_out };

class FleetSchedule {
 public:
  FleetSchedule(const ScheduleParts& made, const Spacing& spacing, Parked parked);

  // Checks all of it. Throws InputError as TimedMap::prove() does, and std::runtime_error where it
  // is not proved of a flight of the stream.
  FleetProof prove(const geom::Execution& run) const;

  // Two of others that come too near each other, which no departure here can change: in a sentence.
  std::string too_near(const RefusedPair& pair) const;

  // A record for each of the stream, in order: with its departure; refused; or as it came. Those
  // that do not depart are left out if `refused` says so.
  std::vector<std::string> records(Refused refused = Refused::kept) const;

  std::size_t refused() const;    // flights without a departure
  std::size_t without() const;    // records of the stream that are no flights
  std::size_t departing() const;  // the other flights of the stream

  // Whether the answer is yes: all depart or, where the others are left out, any. What departs is
  // proved to keep apart from all else; how flights of others are among themselves does not count.
  bool ok(Refused refused = Refused::kept) const;

  // One line of JSON.
  std::string report(const FleetProof& proof, int rounds, Refused refused = Refused::kept) const;

  // Of a flight that is refused, in a sentence.
  std::string why_refused(std::uint32_t number) const;

 private:
  std::string record_of(const FleetStream::Entry& entry) const;
  std::vector<double> delays() const;      // ascending
  std::span<const Departure> own() const;  // of the stream, by number
  std::pair<std::string, std::string> ids(const RefusedPair& pair) const;
  Barred barred(std::uint32_t number) const;  // all its ways
  std::vector<std::string> blocked_ids(const Departure& departure, bool settled) const;
  std::vector<std::string> dropped_ids() const;                // of all records that do not depart
  std::string refusal(const FleetStream::Entry& entry) const;  // JSON
  void add_proof(const FleetProof& proof, geom::JsonLine& line) const;

  ScheduleParts made_;
  const Spacing& spacing_;
  Parked parked_;
  std::vector<std::uint32_t> departing_;  // ways, in order of their numbers; others come last
};

}  // namespace traj
