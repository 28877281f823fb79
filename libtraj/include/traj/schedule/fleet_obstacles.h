#pragma once

// What flights of a fleet keep clear of beside each other: boxes with times, and moving obstacles.
//
// No example: tools/fleet/main.cpp shows the order of the calls of traj/schedule.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "traj/fleet/departures.h"
#include "traj/record/moving_obstacles.h"
#include "traj/schedule/fleet_stream.h"
#include "traj/schedule/timed_map.h"

namespace traj {

// What forbids a way departures that it may have.
struct Barred {
  bool by_map = false;              // its boxes with times
  std::vector<std::string> moving;  // ids of obstacles
};

class FleetObstacles {
 public:
  // `stream` must outlive this. `run`: of the work with what moves.
  FleetObstacles(const FleetStream& stream, Parked parked, const geom::Execution& run)
      : stream_(stream), parked_(parked), run_(run) {}

  // `look_at`: of TimedMap::close(). Before add_moving().
  void add_map(TimedMap map, TimedMap::LookAt look_at);
  // Throws InputError where one is of another map, frame or epoch. `look_at`: of
  // MovingObstacles::require_of(), where there is a map.
  void add_moving(MovingObstacles moving, const MovingObstacles::LookAt& look_at);

  // Says of each flight of the stream when it must not depart, and why. What is settled is passed
  // over, but must be of the map.
  void close(std::vector<FleetFlight>& flights);
  const Barred& barred(std::size_t way) const { return barred_.at(way); }  // after close()

  // Checks each flight of the stream that departs against the whole map, and against each obstacle
  // as skyway-check --moving does. Throws InputError as TimedMap::prove() does, and
  // std::runtime_error where a departure is not proved. What the check of obstacles came to, where
  // there are some.
  std::optional<MovingSummary> prove(std::span<const FleetFlight> flights,
                                     const Departures& departures) const;

 private:
  void close_for_map(std::vector<FleetFlight>& flights);
  void close_for_moving(std::vector<FleetFlight>& flights);
  MovingSummary prove_moving(std::span<const FleetFlight> flights,
                             const Departures& departures) const;

  const FleetStream& stream_;
  Parked parked_;
  geom::Execution run_;
  TimedMap::LookAt look_at_;
  std::optional<TimedMap> map_;
  std::optional<MovingObstacles> moving_;
  std::vector<Barred> barred_;  // by way
};

}  // namespace traj
