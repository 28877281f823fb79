#pragma once

// The aircraft that a mission names, held against the vehicle that it is proved for.
//
// Example:
//   assert(!traj::why_too_small(traj::vehicle_named("tello")->vehicle, "m3e").empty());
//   assert(traj::why_too_small(traj::vehicle_named("m3e")->vehicle, "m3e").empty());

#include <string>
#include <string_view>

#include "geom/record/record.h"
#include "geom/vehicle/vehicle.h"
#include "traj/mission/read_mission.h"

namespace traj {

// Why a proof for this vehicle's box, without a margin, is none for an aircraft that is named as
// vehicle_named() takes it: its box is larger on some side. Empty: the proof is one, or no aircraft
// is named.
std::string why_too_small(const geom::Vehicle& vehicle, std::string_view aircraft);

// Throws geom::InputError(file.id, …) with that.
void require_room_for_aircraft(const geom::Vehicle& vehicle, const FileFlight& file);

// What a flight of the file is made for: for the aircraft that it names where `asked` says no
// vehicle. Throws as require_room_for_aircraft().
geom::Provenance made_for(const FileFlight& file, geom::Provenance asked);

}  // namespace traj
