#include "mission_autopilots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mission_jumps.h"
#include "mission_places.h"

namespace traj {
namespace {

// MavlinkMissionManager::parse_mavlink_mission_item answers these with MAV_MISSION_UNSUPPORTED, and
// heights above terrain with MAV_MISSION_UNSUPPORTED_FRAME, which ends the transfer.
constexpr int kNotForPx4[] = {kLoiterTurns, kSplineWaypoint, kPayloadPlace, kAuxFunction};

// Mission::handleTakeoff of PX4 climbs on the spot and then goes to the item's place, be it 0, 0.
// ArduPilot takes no heed of the place.
bool leads_away(const MissionItem& item) {
  return item.command == kTakeoff && !std::isnan(item.latitude) && !std::isnan(item.longitude) &&
         MissionPlaces::is_here(item);
}

bool is_not_for_px4(const MissionItem& item) {
  if (leads_away(item) || counts_from_terrain(item)) return true;
  return std::find(std::begin(kNotForPx4), std::end(kNotForPx4), item.command) !=
         std::end(kNotForPx4);
}

}  // namespace

bool counts_from_terrain(const MissionItem& item) {
  return item.frame == kGlobalTerrain || item.frame == kGlobalTerrainInt;
}

const MissionItem* not_for_px4(const Mission& mission) {
  const auto found = std::find_if(mission.items.begin(), mission.items.end(), is_not_for_px4);
  return found == mission.items.end() ? nullptr : &*found;
}

std::vector<Autopilot> autopilots_that_load(const Mission& mission, const MissionRules& rules,
                                            std::string_view source) {
  std::vector<Autopilot> out = rules.autopilots;
  const MissionItem* const item = not_for_px4(mission);
  if (!item || out.empty()) return out;
  std::erase_if(out, [](const Autopilot& one) { return one.firmware == Firmware::px4; });
  if (!out.empty()) return out;
  if (leads_away(*item)) {
    refuse_item(source, *item,
                {.expected = "a place",
                 .found = "a take-off at latitude 0, longitude 0",
                 .advice = "PX4 flies there when it has climbed"});
  }
  refuse_item(
      source, *item,
      {.expected = "what PX4 flies",
       .found = counts_from_terrain(*item) ? "a height above terrain"
                                           : fmt::format("command {}", item->command),
       .advice =
           "PX4 loads no mission with it, and no other autopilot is asked for (--autopilot)"});
}

bool flown_by(Firmware firmware, const MissionRules& rules) {
  return !rules.autopilots.empty() &&
         std::all_of(rules.autopilots.begin(), rules.autopilots.end(),
                     [&](const Autopilot& one) { return one.firmware == firmware; });
}

}  // namespace traj
