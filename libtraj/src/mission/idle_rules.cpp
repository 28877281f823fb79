#include "traj/mission/idle_rules.h"

#include <algorithm>

namespace traj {

std::optional<std::string> idle_rule(const MissionRules& rules,
                                     std::span<const FileFlight> flights) {
  const auto any = [&](auto uses) {
    return std::any_of(flights.begin(), flights.end(), [&](const FileFlight& one) {
      const FlownMission* mission = mission_of(one.flown);
      return mission && uses(*mission);
    });
  };
  const auto has_terrain = [&](bool surface) {
    return any([&](const FlownMission& one) {
      return one.terrain && one.terrain->surface.has_value() == surface;
    });
  };
  if (rules.terrain && rules.terrain->error && !has_terrain(false)) {
    return "--terrain-error is for heights above terrain";
  }
  if (rules.terrain && rules.terrain->surface && !has_terrain(true)) {
    return "--surface-band is for waylines of DJI that follow the surface";
  }
  if (rules.ground && !any([](const FlownMission& one) { return one.counts_from_flat_ground; })) {
    return "--terrain-height is for heights above terrain";
  }
  if (rules.return_height && !any([](const FlownMission& one) { return one.ends_at_home; })) {
    return "--return-height is for a return home at the mission's end";
  }
  return std::nullopt;
}

}  // namespace traj
