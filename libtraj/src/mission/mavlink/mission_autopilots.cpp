#include "mission_autopilots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geom/base/error.h"
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

namespace {

// PX4 loads no mission with such an item.
void switch_fence_on(Autopilot& autopilot) {
  if (autopilot.firmware != Firmware::ardupilot) return;
  autopilot.fence = autopilot.switched_fence;
  autopilot.rally_in_fence = true;
}

// Those that fly the first item. ArduPilot (AP_Mission::read_cmd_from_storage) has home in its
// place.
std::vector<Autopilot> flying_all(const Mission& mission, const MissionRules& rules,
                                  std::string_view source) {
  std::vector<Autopilot> out = rules.autopilots;
  if (!mission.first_for_home || out.empty() || mission.items.empty()) return out;
  std::erase_if(out, [](const Autopilot& one) { return one.firmware == Firmware::ardupilot; });
  if (!out.empty()) return out;
  refuse_item(source, mission.items.front(),
              {.expected = "home as the first item (frame 0, command 16)",
               .found = fmt::format("frame {}, command {}", mission.items.front().frame,
                                    mission.items.front().command),
               .advice = "ArduPilot takes the first item for home and does not fly it: put home "
                         "before it, or say that PX4 flies it (--autopilot px4)"});
}

}  // namespace

bool switches_fence_on(const Mission& mission) {
  return std::any_of(mission.items.begin(), mission.items.end(), [](const MissionItem& item) {
    // Cut to a whole number, 0 is off. Until 4.5 every other number is on; later 2 is off but for
    // the lowest altitude (ModeAuto::start_command, AP_Mission::start_command_fence).
    return item.command == kEnableFence && !(std::abs(item.param[0]) < 1);
  });
}

std::vector<Autopilot> autopilots_that_load(const Mission& mission, const MissionRules& rules,
                                            std::string_view source) {
  std::vector<Autopilot> out = flying_all(mission, rules, source);
  if (switches_fence_on(mission)) {
    for (Autopilot& one : out) switch_fence_on(one);
  }
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

void require_legs_are_kept(const MissionRules& rules, std::string_view source) {
  for (const Autopilot& one : rules.autopilots) {
    if (one.keeps_to_legs) continue;
    throw geom::InputError(
        source,
        {.expected = "an autopilot that keeps to the legs of a mission",
         .found = one.firmware == Firmware::px4
                      ? "one that goes round obstacles or stops its descents (COM_OBS_AVOID "
                        "or NAV_MIN_GND_DIST is above 0)"
                      : "one that goes round obstacles (OA_TYPE is not 0)",
         .advice = "nobody knows which way it takes then"});
  }
}

// PX4 (MissionBase::on_active) advances only from an item whose autocontinue is 1.
void require_goes_on(const Mission& mission, std::span<const std::size_t> order,
                     const MissionRules& rules, std::string_view source) {
  if (flown_by(Firmware::ardupilot, rules)) return;
  const MissionItem* stays = nullptr;
  for (const std::size_t i : order) {
    const MissionItem& item = mission.items[i];
    if (stays && !moves_nothing(item.command)) {
      refuse_item(source, *stays,
                  {.key = "autocontinue",
                   .expected = "1, where other items follow",
                   .found = "0",
                   .advice = "PX4 stays there until somebody makes it go on; ArduPilot does not "
                             "heed it (--autopilot)"});
    }
    if (!item.goes_on) stays = &item;
  }
}

// PX4 (MissionBase) looks for a beacon where the second parameter is 1 or 2: it climbs to search,
// and lands beside its place. ArduPilot does so where PLND_ENABLED says so.
void require_lands_below(const MissionItem& landing, const MissionRules& rules,
                         std::string_view source) {
  const double precision = landing.param[1];
  if (!flown_by(Firmware::ardupilot, rules) && !std::isnan(precision) && precision != 0) {
    refuse_item(source, landing,
                {.key = "the precision of a landing (parameter 2)",
                 .expected = "0",
                 .found = fmt::to_string(precision),
                 .advice = "it may climb, and land beside a beacon"});
  }
  for (const Autopilot& one : rules.autopilots) {
    if (one.lands_below) continue;
    refuse_item(source, landing,
                {.expected = "an autopilot that lands straight below",
                 .found = "one that lands beside a beacon (PLND_ENABLED is not 0)"});
  }
}

bool flown_by(Firmware firmware, const MissionRules& rules) {
  return !rules.autopilots.empty() &&
         std::all_of(rules.autopilots.begin(), rules.autopilots.end(),
                     [&](const Autopilot& one) { return one.firmware == firmware; });
}

bool returns_below(const MissionRules& rules, double height) {
  return std::any_of(rules.autopilots.begin(), rules.autopilots.end(), [&](const Autopilot& one) {
    return one.fence.return_ceiling && *one.fence.return_ceiling < height;
  });
}

double most_return_climb(const MissionRules& rules) {
  double most = 0;
  for (const Autopilot& one : rules.autopilots) most = std::max(most, one.return_climb);
  return most;
}

double least_return_slope(const MissionRules& rules) {
  double least = 0;
  for (const Autopilot& one : rules.autopilots) {
    if (one.return_slope > 0 && (least == 0 || one.return_slope < least)) least = one.return_slope;
  }
  return least;
}

}  // namespace traj
