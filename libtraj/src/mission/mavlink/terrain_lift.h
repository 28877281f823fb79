#pragma once

// A mission with heights above terrain: flown over flat ground first, then raised over the terrain.
//
// ArduPilot plans such a mission as if the ground were as flat as at home, and adds the terrain's
// height over that at home to each place (AC_WPNav::advance_wp_target_along_track). So every region
// of the flat flight becomes one that reaches from the lowest terrain that may count to the
// highest.

#include <string_view>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// Whether the height of any item counts from the terrain.
bool counts_from_terrain(const Mission& mission);

// Whether its waypoints count from the terrain by such rules, so that the flight must be raised.
// Throws geom::InputError(source, line, …) at an item that cannot be told then: a waypoint that
// counts from elsewhere, an altitude of 0, a climb (31), a payload's place.
bool counts_from_terrain(const Mission& mission, const MissionRules& rules,
                         std::string_view source);

// `flat` is the flight with heights above terrain counted from home's ground; `latitude` is home's,
// in degrees. Over home the terrain is as high as home. A return counts from home; its height is
// known where that is above all heights at which it may begin (else FlownMission::returns). Sweeps
// and drift are cut into pieces of some 25 m, and so is the path, which gets a band of heights
// around it (FlownLegs::leg_band). The result has no times of legs and no velocities;
// FlownMission::least_seconds estimates its whole time. Throws geom::InputError(source, …)
// where the height model does not know the ground.
FlownMavlink raised_over_terrain(FlownMavlink flat, const MissionRules& rules, double latitude,
                                 std::string_view source);

}  // namespace traj
