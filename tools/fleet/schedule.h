#pragma once

// What was chosen for a stream, as records and as a report.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/text/json_line.h"
#include "obstacles.h"
#include "stream.h"
#include "traj/fleet/departures.h"
#include "traj/together/check_together.h"

namespace fleet {

// What a schedule is made of. All must outlive it.
struct Made {
  const Stream& stream;
  const Obstacles& obstacles;
  std::span<const traj::FleetFlight> flights;
  const traj::FleetConflicts& conflicts;
  const traj::Departures& departures;
};

// That all that departs keeps apart.
struct Proof {
  traj::TogetherResult together;  // refused: pairs of two that are settled, and no others
  std::optional<traj::MovingSummary> moving;
};

class Schedule {
 public:
  Schedule(const Made& made, const traj::Spacing& spacing, traj::Parked parked);

  // Checks all of it. Throws InputError as TimedMap::prove() does, and std::runtime_error where it
  // is not proved of a flight of the stream.
  Proof prove(const geom::Execution& run) const;

  // Two of others that come too near each other, which no departure here can change: in a sentence.
  std::string too_near(const traj::RefusedPair& pair) const;

  // A record for each of the stream, in order: with its departure; refused; or as it came.
  std::vector<std::string> records() const;

  std::size_t refused() const;  // flights without a departure
  std::size_t without() const;  // records of the stream that are no flights

  // One line of JSON.
  std::string report(const Proof& proof, int rounds) const;

  // Of a flight that is refused, in a sentence.
  std::string why_refused(std::uint32_t number) const;

 private:
  std::string record_of(const Stream::Entry& entry) const;
  std::vector<double> delays() const;            // ascending
  std::span<const traj::Departure> own() const;  // of the stream, by number
  std::pair<std::string, std::string> ids(const traj::RefusedPair& pair) const;
  Barred barred(std::uint32_t number) const;  // all its ways
  std::vector<std::string> blocked_ids(const traj::Departure& departure, bool settled) const;
  std::string refusal(const Stream::Entry& entry) const;  // JSON
  void add_proof(const Proof& proof, geom::JsonLine& line) const;

  Made made_;
  const traj::Spacing& spacing_;
  traj::Parked parked_;
  std::vector<std::uint32_t> departing_;  // ways, in order of their numbers; others come last
};

}  // namespace fleet
