#pragma once

// Departures that a map's boxes with times leave, and the proof of them.
//
// No example: tools/fleet/main.cpp shows the order of the calls of traj/schedule.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "geom/record/agreed_room.h"
#include "traj/fleet/departures.h"
#include "traj/schedule/fleet_stream.h"
#include "traj/together/timed_flight.h"

namespace traj {

class TimedMap {
 public:
  // `asked`: the vehicle of records which name none. `budget`: of CollisionOptions.
  TimedMap(geom::BoxMap map, std::string name, geom::AskedRoom asked, std::size_t budget,
           const geom::Execution& run)
      : map_(std::move(map)),
        name_(std::move(name)),
        asked_(std::move(asked)),
        budget_(budget),
        run_(run) {}

  // Asked of each trajectory that is closed for, with the id of its record; it may throw.
  using LookAt = std::function<void(const Trajectory&, const std::string& id)>;

  // Says of each flight that is not settled when it must not depart. Throws InputError where a
  // record is of another map or epoch, and UsageError where it names no vehicle.
  void close(const FleetStream& stream, Parked parked, const LookAt& look_at,
             std::vector<FleetFlight>& flights) const;

  // Checks each of them that departs against the whole map, at its departure. Throws InputError for
  // one that the check refuses at any departure, std::runtime_error for one that it refuses at
  // this.
  void prove(const FleetStream& stream, std::span<const FleetFlight> flights,
             const Departures& departures, Parked parked) const;

  const geom::BoxMap& map() const { return map_; }

 private:
  // Calls f(scene, way) for the ways, on all threads, for each vehicle in turn.
  template <class F>
  void each(const FleetStream& stream, std::vector<std::size_t> ways, const F& f) const;

  geom::BoxMap map_;
  std::string name_;
  geom::AskedRoom asked_;
  std::size_t budget_;
  geom::Execution run_;
};

}  // namespace traj
