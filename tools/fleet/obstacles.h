#pragma once

// What flights of a fleet keep clear of beside each other: --map and --moving.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/option/moving.h"
#include "stream.h"
#include "timed_map.h"
#include "traj/fleet/departures.h"

namespace fleet {

// What forbids a way departures that it may have.
struct Barred {
  bool by_map = false;              // its boxes with times
  std::vector<std::string> moving;  // ids of obstacles
};

class Obstacles {
 public:
  // `common` and `stream` must outlive this. `metres`: whether what is over a map may be degrees.
  Obstacles(const cli::Common& common, const Stream& stream, traj::Parked parked,
            const cli::MetresOption& metres)
      : common_(common), stream_(stream), parked_(parked), metres_(metres) {}

  // TimedMap's. Before add_moving().
  void add_map(const std::string& file, const cli::VehicleOptions& vehicle);
  // Reads them. Throws InputError where one is bad, or of another map, frame or epoch.
  void add_moving(cli::Moving moving);

  // Says of each flight of the stream when it must not depart, and why. What is settled is passed
  // over, but must be of the map.
  void close(std::vector<traj::FleetFlight>& flights);
  const Barred& barred(std::size_t way) const { return barred_.at(way); }  // after close()

  // Checks each flight of the stream that departs against the whole map, and against each obstacle
  // as skyway-check --moving does. Throws InputError as TimedMap::prove() does, and
  // std::runtime_error where a departure is not proved. What the check of obstacles came to, where
  // there are some.
  std::optional<traj::MovingSummary> prove(std::span<const traj::FleetFlight> flights,
                                           const traj::Departures& departures) const;

 private:
  void close_for_map(std::vector<traj::FleetFlight>& flights);
  void close_for_moving(std::vector<traj::FleetFlight>& flights);
  traj::MovingSummary prove_moving(std::span<const traj::FleetFlight> flights,
                                   const traj::Departures& departures) const;

  const cli::Common& common_;
  const Stream& stream_;
  traj::Parked parked_;
  cli::MetresOption metres_;
  std::optional<TimedMap> map_;
  std::optional<cli::Moving> moving_;
  std::vector<Barred> barred_;  // by way
};

}  // namespace fleet
