#pragma once

// Which autopilots a mission is for.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "traj/mission/mavlink/mission_flight.h"

namespace traj {

// The first item that PX4 does not fly as ArduPilot does: turns on a circle, splines, payload
// places, auxiliary functions and heights above terrain, with which PX4 loads no mission, and a
// take-off at latitude 0, longitude 0, to which PX4 flies. Null: there is none.
const MissionItem* not_for_px4(const Mission& mission);

bool counts_from_terrain(const MissionItem& item);

// Whether an item of it (207) switches a fence on.
bool switches_fence_on(const Mission& mission);

// Those of the rules' autopilots that fly the mission as it is read here. Throws
// geom::InputError(source, line, …) where that is none of them. Their fences are those that the
// mission switches on.
std::vector<Autopilot> autopilots_that_load(const Mission& mission, const MissionRules& rules,
                                            std::string_view source);

// Whether all autopilots of the rules are of that firmware.
bool flown_by(Firmware firmware, const MissionRules& rules);

// m that a return climbs at most, whatever its height.
double most_return_climb(const MissionRules& rules);

// Whether a fence of one of them keeps it from returning so high, m above home.
bool returns_below(const MissionRules& rules, double height);

// The least slope of the cones within which a return stays low; 0: there is none.
double least_return_slope(const MissionRules& rules);

// Throws geom::InputError(source, …) where one of the rules' autopilots goes round obstacles as it
// likes.
void require_legs_are_kept(const MissionRules& rules, std::string_view source);

// Throws geom::InputError(source, line, …) where PX4 may fly the mission, whose items are flown in
// this order, and would stay at one of them for ever although others that move it follow.
void require_goes_on(const Mission& mission, std::span<const std::size_t> order,
                     const MissionRules& rules, std::string_view source);

// Throws geom::InputError(source, line, …) where one of them does not land straight below its
// place.
void require_lands_below(const MissionItem& landing, const MissionRules& rules,
                         std::string_view source);

}  // namespace traj
