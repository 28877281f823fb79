#pragma once

// Planned ways home: from every instant of a flight a way to a landing site.
//
// Example:
//   traj::WaysTask task;
//   task.models = {traj::return_model(traj::px4("1.17"))};
//   task.sites = {{"pad", {1, 1, 0}, {1, 1, 5}}};
//   const traj::WaysHome home = traj::ways_home(scene, traj::stages_of(trajectory), task);
//   for (const traj::WayHome& way : home.ways) {
//     std::cout << way.from << " to " << way.until << " s: " << way.length << " m\n";
//   }

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "traj/flight/energy.h"
#include "traj/home/flight_stage.h"
#include "traj/home/landing_site.h"
#include "traj/home/return_model.h"

namespace traj {

// A path from a place to LandingSite::above, every leg free; nothing if none was found. Threads may
// call it at once.
using WayPlanner =
    std::function<std::optional<geom::Polyline>(const Vec3& from, const LandingSite& site)>;

struct WaysTask {
  std::vector<ReturnModel> models;  // any of which may brake; at least one
  std::vector<LandingSite> sites;   // at least one
  WayPlanner plan = {};             // asked where a climb, a level way and a descent are no good
  std::optional<Energy> energy = {};
  double detour = 1.5;  // a way is shared while it is at most so long, over the straight distance
  double finest = 0.5;  // m: shorter stages are not divided
};

// From any instant between `from` and `until` (s of the flight, closed) the vehicle brakes, flies
// straight to the first of `points`, then along them with a rest at each, and sinks from the last
// but one to the last, which is on the ground of the site.
struct WayHome {
  double from = 0;
  double until = 0;
  std::size_t site = 0;  // an index
  geom::Polyline points;
  double length = 0;    // m from where it comes to rest to the ground, at most
  double duration = 0;  // s from the order to the ground, at most
  // With an energy: the last instant, not after `until`, up to which there is enough for the way
  // from each instant since `from`; nothing where there is not even at `from`.
  std::optional<double> latest_departure = {};
};

// A time from which no way was found.
struct WayGap {
  double from = 0;  // s of the flight, closed
  double until = 0;
  Vec3 place = Vec3::Zero();  // m: where the flight is then
};

struct WaysHome {
  double duration = 0;        // s of the flight
  std::vector<WayHome> ways;  // ascending
  std::vector<WayGap> gaps;   // ascending, apart
};

// The part of the time that ways cover, 0 to 1.
double share(const WaysHome& home);

// Whether there is a way, and energy for it, from every instant.
bool complete(const WaysHome& home, const WaysTask& task);

// Ways for all stages (contiguous, ascending). A way is for all instants of its time: from wherever
// the vehicle comes to rest (braking_region of every model) the straight way to the first point,
// every leg, and what the models overshoot beyond each point, are inside the bounds and clear of the
// map, boxes with times counting as always there. Nothing is sampled. The margin of the scene must
// hold what the models may be off (`around`; least_margin of home_flight.h). Sites are tried in the
// order of their straight distance, up to the length of the way that was found. A stage for which
// nothing is found is halved, down to `finest`. Threads may call it at once; the answer is always
// the same.
//
// Throws InputError where the wind of the energy is not below the speed of a model or a limit of
// the vehicle.
WaysHome ways_home(const geom::CollisionScene& scene, std::span<const FlightStage> stages,
                   const WaysTask& task);

}  // namespace traj
