#pragma once

// --map of skyway-fleet: departures that a map's boxes with times leave, and the proof of them.

#include <span>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "geom/map/box_map.h"
#include "stream.h"
#include "traj/fleet/departures.h"
#include "traj/together/timed_flight.h"

namespace fleet {

class TimedMap {
 public:
  // Opens and verifies the map. `vehicle` is that of records which name none. `common` must outlive
  // this.
  TimedMap(const std::string& file, cli::VehicleOptions vehicle, const cli::MetresOption& metres,
           const cli::Common& common);

  // Says of each flight that is not settled when it must not depart. Throws InputError where a
  // record is of another map or epoch or looks like degrees, and UsageError where it names no
  // vehicle.
  void close(const Stream& stream, traj::Parked parked,
             std::vector<traj::FleetFlight>& flights) const;

  // Checks each of them that departs against the whole map, at its departure. Throws InputError for
  // one that the check refuses at any departure, std::runtime_error for one that it refuses at
  // this.
  void prove(const Stream& stream, std::span<const traj::FleetFlight> flights,
             const traj::Departures& departures, traj::Parked parked) const;

  const geom::BoxMap& map() const { return map_; }

 private:
  // Calls f(scene, way) for the ways, on all threads, for each vehicle in turn.
  template <class F>
  void each(const Stream& stream, std::vector<std::size_t> ways, const F& f) const;

  std::string file_;
  cli::VehicleOptions vehicle_;
  cli::MetresOption metres_;
  const cli::Common& common_;
  geom::BoxMap map_;
};

}  // namespace fleet
