#pragma once

// What proving a return takes of a flight: stages and a model for each autopilot, and the places.
//
// Example:
//   const traj::FlightReturn of = traj::flight_return(scene, trajectory, {}, 60);
//   const traj::ReturnReport proof = traj::prove_return(scene, of.stages, of.task);

#include <optional>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/home/return_proof.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/formats/flier.h"

namespace traj {

struct FlightReturn {
  std::vector<std::vector<FlightStage>> stages;  // one list for each of the task's models
  ReturnTask task;
  std::vector<TimedPlace> timeline = {};  // of a mission, by the first model
};

// As each autopilot of the flier that loads the mission may fly it, to the mission's home or one of
// its rally points, within its fences. `height`: m above home, in place of the firmwares' own
// (Flier::return_height, whose throws it has). The mission knows its home (precondition).
FlightReturn flight_return(const FlownMission& mission, const Flier& flier,
                           const std::optional<double>& height);

// As an aircraft of DJI flies it, from its way down to the ground, too. `height`: m above home,
// where the file does not say it. `speed`: m/s, where the mission does not say it. Throws
// geom::UsageError where nobody says the speed, or the height and `height_counts`. The mission
// knows its home (precondition).
struct DjiReturnAsked {
  std::optional<double> height = {};
  std::optional<double> speed = {};
  bool height_counts = true;  // false: it lands, or stays
};
FlightReturn dji_flight_return(const geom::CollisionScene& scene, FlownMission mission,
                               const Flier& flier, const DjiReturnAsked& asked);

// From every one of these stages of a flight between two places, in the axes of the scene's map, to
// the ground below the first, by each autopilot of the flier. It stands on the level ground below
// either place.
FlightReturn flight_return(const geom::CollisionScene& scene,
                           const std::vector<FlightStage>& stages, const Vec3& begin,
                           const Vec3& end, const Flier& flier,
                           const std::optional<double>& height);

// The same of a trajectory.
FlightReturn flight_return(const geom::CollisionScene& scene, const Trajectory& trajectory,
                           const Flier& flier, const std::optional<double>& height);

}  // namespace traj
