#pragma once

// What a user says of a vehicle's settings, and no flight of a file uses.
//
// Example:
//   const traj::MissionRules rules{.return_height = 60};
//   const std::vector<traj::FileFlight> flights{{.flown = {traj::FlownMission{}}}};
//   assert(traj::idle_rule(rules, flights)->starts_with("--return-height"));

#include <optional>
#include <span>
#include <string>

#include "traj/mission/read_mission.h"

namespace traj {

// The first option that changes nothing, in words: the height of a return, of flat ground, the
// error of terrain or the band over a surface. Nothing where each of them that is given is used.
std::optional<std::string> idle_rule(const MissionRules& rules,
                                     std::span<const FileFlight> flights);

}  // namespace traj
