#pragma once

// What was chosen for a stream, as records and as a report.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "stream.h"
#include "traj/fleet/departures.h"
#include "traj/together/check_together.h"

namespace fleet {

// What a schedule is made of. All must outlive it.
struct Made {
  const Stream& stream;
  std::span<const traj::FleetFlight> flights;
  const traj::FleetConflicts& conflicts;
  const traj::Departures& departures;
};

class Schedule {
 public:
  Schedule(const Made& made, const traj::Spacing& spacing, traj::Parked parked)
      : made_(made), spacing_(spacing), parked_(parked) {}

  // Those that depart, at their times, for the proof.
  std::vector<traj::TimedFlight> timed() const;

  // A record for each of the stream, in order: with its departure; refused; or as it came.
  std::vector<std::string> records() const;

  std::size_t refused() const;  // flights without a departure
  std::size_t without() const;  // records of the stream that are no flights

  // One line of JSON. `proof` is of timed().
  std::string report(const traj::TogetherResult& proof, int rounds) const;

  // Of a flight that is refused, in a sentence.
  std::string why_refused(std::uint32_t number) const;

 private:
  std::string record_of(const Stream::Entry& entry) const;
  std::vector<double> delays() const;  // ascending
  std::vector<std::string> blocked_ids(const traj::Departure& departure) const;

  Made made_;
  const traj::Spacing& spacing_;
  traj::Parked parked_;
};

}  // namespace fleet
