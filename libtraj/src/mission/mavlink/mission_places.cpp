#include "mission_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mission_autopilots.h"
#include "mission_jumps.h"

namespace traj {

MissionPlaces::MissionPlaces(const Mission& mission, const MissionFrame& frame,
                             const MissionRules& rules, std::string_view source)
    : mission_(mission),
      frame_(frame),
      rules_(rules),
      earth_(frame.origin),
      home_(rules.home),
      source_(source) {
  if (!home_ && mission_.home && frame_.height_known) {
    home_ = above_sea(*mission_.home);
  }
}

double MissionPlaces::above_sea(const geom::GeodeticPlace& place) const {
  return place.height + frame_.sea_level(place.latitude, place.longitude) - frame_.origin.height;
}

bool MissionPlaces::counts_from_sea() const {
  const bool home = !rules_.home && home_.has_value();
  return home || std::any_of(mission_.items.begin(), mission_.items.end(), [](const auto& item) {
           const bool above_sea = item.frame == kGlobal || item.frame == kGlobalInt;
           return above_sea &&
                  (item.command == kTakeoff || item.command == kLand || is_there(item));
         });
}

double MissionPlaces::above_home(const MissionItem& item, double height) const {
  if (home_) return *home_ + height;
  if (!mission_.home) {
    refuse_item(source_, item,
                {.says = "heights count from home, and the file has no home",
                 .advice = "give the height of the ground there (--ground)"});
  }
  refuse_item(source_, item,
              {.says = "heights count from home, which the file gives above the sea, and the map "
                       "does not say how high its z = 0 is",
               .advice = "give the map's z of the ground there (--ground)"});
}

double MissionPlaces::height(const MissionItem& item) const {
  if (!(std::abs(item.altitude) <= 1e5)) {
    refuse_item(source_, item,
                {.key = "altitude",
                 .expected = "a number within 1e5 m",
                 .found = fmt::to_string(item.altitude)});
  }
  switch (item.frame) {
    case kGlobal:
    case kGlobalInt:
      if (!frame_.height_known) {
        refuse_item(source_, item,
                    {.expected = "heights above home",
                     .found = "one above the sea, and the map does not say how high its z = 0 is",
                     .advice = "give --origin latitude,longitude,height"});
      }
      return above_sea({item.latitude, item.longitude, item.altitude});
    case kGlobalRelative:
    case kGlobalRelativeInt:
      return above_home(item, item.altitude);
    case kGlobalTerrain:
    case kGlobalTerrainInt:
      if (rules_.ground) return *rules_.ground + item.altitude;
      if (rules_.terrain) return above_home(item, item.altitude);  // to be raised (terrain_lift.h)
      refuse_item(source_, item,
                  {.expected = "heights above sea level or home",
                   .found = "one above terrain",
                   .advice = "where the ground is flat, give its height; over other ground an "
                             "autopilot follows terrain data of its own, which no file shows: "
                             "give a height model of it (--ground-model)"});
    default:
      refuse_item(source_, item,
                  {.key = "frame",
                   .expected = "0, 3, 5, 6, 10 or 11 (above sea level, home or terrain)",
                   .found = fmt::to_string(item.frame)});
  }
}

bool MissionPlaces::is_here(const MissionItem& item) {
  constexpr double kUnit = 1e-7;  // degrees
  return std::isnan(item.latitude) || std::isnan(item.longitude) ||
         (std::abs(item.latitude) < kUnit && std::abs(item.longitude) < kUnit);
}

// A landing goes to the ground whatever it says, and a climb (31) to the height above home.
bool MissionPlaces::keeps_height(const MissionItem& item) {
  constexpr double kUnit = 0.01;  // m
  return item.command != kLand && item.command != kLoiterToHeight &&
         std::abs(item.altitude) < kUnit;
}

bool MissionPlaces::is_there(const MissionItem& item) {
  constexpr int kThere[] = {kWaypoint,   kSplineWaypoint, kLoiterForever,
                            kLoiterTime, kLoiterTurns,    kLoiterToHeight};
  return std::find(std::begin(kThere), std::end(kThere), item.command) != std::end(kThere) ||
         (item.command == kLand && !is_here(item));
}

Vec3 MissionPlaces::place(const MissionItem& item, const std::optional<Vec3>& here) const {
  if (!(std::abs(item.latitude) <= 90) || !(std::abs(item.longitude) <= 180)) {
    refuse_item(source_, item,
                {.key = "latitude and longitude",
                 .expected = "within 90 and 180 degrees",
                 .found = fmt::format("{} {}", item.latitude, item.longitude)});
  }
  if (!is_here(item) || flown_by(Firmware::px4, rules_)) {
    return on_map(item, {item.latitude, item.longitude, 0}, height_or(item, here));
  }
  if (!flown_by(Firmware::ardupilot, rules_)) {
    refuse_item(source_, item,
                {.expected = "a place",
                 .found = "latitude 0, longitude 0",
                 .advice = "ArduPilot then stays where it is, and PX4 flies there: say which of "
                           "them flies it (--autopilot)"});
  }
  if (!here) {
    refuse_item(
        source_, item,
        {.expected = "a place", .found = "latitude 0, longitude 0, and no place before it"});
  }
  return {here->x(), here->y(), height_or(item, here)};
}

double MissionPlaces::height_or(const MissionItem& item, const std::optional<Vec3>& here) const {
  if (!keeps_height(item)) return height(item);
  if (item.command == kTakeoff) {
    refuse_item(source_, item, {.expected = "the height of the take-off", .found = "0"});
  }
  if (flown_by(Firmware::px4, rules_)) return height(item);
  if (here && flown_by(Firmware::ardupilot, rules_)) return here->z();
  refuse_item(source_, item,
              {.expected = "an altitude",
               .found = "0",
               .advice = "ArduPilot then keeps its height, and PX4 flies at that of home: say "
                         "which of them flies it (--autopilot)"});
}

Vec3 MissionPlaces::on_map(const MissionItem& item, const geom::GeodeticPlace& at, double z) const {
  if (!is_near(frame_.origin, at.latitude, at.longitude)) {
    refuse_item(source_, item,
                {.expected = fmt::format("a place near the origin {} {}", frame_.origin.latitude,
                                         frame_.origin.longitude),
                 .found = fmt::format("{} {}", at.latitude, at.longitude)});
  }
  Vec3 p = earth_.enu(at);
  p.z() = z;
  return p;
}

}  // namespace traj
