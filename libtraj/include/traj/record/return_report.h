#pragma once

// What is known of the ways home from every instant of a flight, as reports have it.
//
// Example:
//   traj::ReturnReport returns{.action = "rtl", .autopilot = "px4:1.17", .height = 60};
//   returns.duration = 120;
//   returns.gaps.push_back({.from = 30, .until = 42, .phase = "way"});
//   assert(!returns.ok() && returns.share() == 0.9);

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"
#include "traj/proof/flight_part.h"
#include "traj/proof/reason.h"

namespace traj {

// A time, s of the flight, from which no return is proved, and the first reason that was found.
struct ReturnGap {
  double from = 0;
  double until = 0;
  std::optional<FlightPart> part = {};  // of a mission
  std::string autopilot = {};
  std::string_view phase = {};            // "braking", "climb", "way", "descent" or "landing"
  Reason reason = Reason::collision;      // or bounds, fence, landing, return_home
  geom::Vec3 place = geom::Vec3::Zero();  // m: of what it would meet
  std::optional<std::size_t> box = {};    // an index into the map
  std::optional<std::size_t> fence = {};  // of the mission
};

// Where a vehicle is on its way at a time, s of the flight.
struct TimedPlace {
  double time = 0;
  geom::Vec3 place = geom::Vec3::Zero();  // m
};

struct ReturnReport {
  std::string action;
  std::string autopilot;                 // those for which it holds
  geom::Vec3 home = geom::Vec3::Zero();  // the ground there, m
  double height = 0;                     // m above home, of the return
  double duration = 0;                   // s, of the flight
  double longest = 0;                    // s that a return may take: an estimate
  std::vector<ReturnGap> gaps = {};      // ascending, apart
  // Where a mission or a path is when, in ascending time. Between two entries the way is straight.
  // The times are estimates. If several autopilots may fly, the first one does.
  std::vector<TimedPlace> timeline = {};
  bool least_sought = false;                // whether it was looked for:
  std::optional<double> least_height = {};  // m above home with which there is no gap
  std::string reasons = {};                 // JSON (return_reasons), where they are asked for
  std::vector<geom::Vec3> way = {};         // beside these, of a mission: with ascent and descent

  // If there is none: the least height at which returns are proved for as long as at any that the
  // bounds allow, and that share.
  std::optional<double> best_height = {};
  std::optional<double> best_share = {};

  bool ok() const { return gaps.empty(); }
  double share() const;  // of the time from which a return is proved, 0 to 1
};

}  // namespace traj
