#pragma once

// What happens if the link to a vehicle is lost, in words for the authority that is asked.
//
// Example:
//   traj::LostLink what;
//   what.id = "q1";
//   what.origin = {47.4, 8.5, 400};
//   what.proof.duration = 60;
//   assert(traj::lost_link_procedure(scene, what).starts_with("Lost-link procedure of flight q1"));

#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/map/frame.h"
#include "traj/home/flight_return.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/formats/flier.h"
#include "traj/record/return_report.h"

namespace traj {

struct LostLink {
  std::string id;        // of the flight
  FlownMission mission;  // as it was read back, in the map's axes
  FlightReturn flight;   // of it
  ReturnReport proof;    // with the mission's fences
  Flier flier;
  std::vector<GeodeticFence> fences;
  geom::GeodeticOrigin origin;  // of the map's (0, 0, 0)
};

// Text, a few pages at most: what the vehicle does and from which item on, heights, places, fences,
// the times from which no return is proved, what this rests on, and what is not proved.
std::string lost_link_procedure(const geom::CollisionScene& scene, const LostLink& what);

}  // namespace traj
