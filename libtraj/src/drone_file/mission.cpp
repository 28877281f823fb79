#include "traj/drone_file/mission.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"

namespace traj {
namespace {

double to_1e7(double degrees) { return std::round(degrees * 1e7) / 1e7; }
double to_millimetres(double metres) { return std::round(metres * 1e3) / 1e3; }

MissionItem item_at(const geom::GeographicFrame& earth, int command, const Vec3& p, double home) {
  const geom::GeodeticPlace place = earth.place(p);
  MissionItem item;
  item.command = command;
  item.latitude = to_1e7(place.latitude);
  item.longitude = to_1e7(place.longitude);
  item.altitude = to_millimetres(p.z() - home);
  return item;
}

// MAV_CMD of what changes no place and no height: conditions on time, distance and yaw, the start
// of a landing as a mark, relays and servos, regions of interest, cameras, mounts, the fence's
// switch, grippers, gimbals.
constexpr int kMovesNothing[] = {112, 114, 115,  181,  182,  183,  184,  189,  195, 196, 197,
                                 200, 201, 202,  203,  204,  205,  206,  207,  211, 214, 530,
                                 531, 532, 1000, 1001, 2000, 2001, 2003, 2500, 2501};

constexpr double kSamePlace = 0.5;  // m: home and a take-off that mean the same

class Flight {
 public:
  Flight(const Mission& mission, const MissionFrame& frame, std::optional<double> home,
         std::string_view source)
      : mission_(mission), frame_(frame), earth_(frame.origin), home_(home), source_(source) {
    if (!home_ && mission.home) home_ = above_sea(mission.home->height);
  }

  FlownMission fly() {
    for (index_ = 0; index_ < mission_.items.size(); ++index_) take(mission_.items[index_]);
    if (flown_.path.empty()) {
      throw geom::InputError(source_, "expected at least one waypoint, found none");
    }
    if (unsaid_speed_) flown_.speed.reset();
    return std::move(flown_);
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    const std::size_t line = mission_.items[index_].line;
    throw geom::InputError(source_, line,
                           line ? message : fmt::format("item {}: {}", index_, message));
  }

  double above_sea(double height) const { return height + frame_.geoid - frame_.origin.height; }

  double height(const MissionItem& item) const {
    if (!(std::abs(item.altitude) <= 1e5)) {
      refuse(fmt::format("altitude must be a number within 1e5 m, found {}", item.altitude));
    }
    if (item.frame == kGlobal || item.frame == kGlobalInt) return above_sea(item.altitude);
    if (item.frame != kGlobalRelative && item.frame != kGlobalRelativeInt) {
      refuse(fmt::format("frame must be 0, 3, 5 or 6 (above sea level or home), found {}",
                         item.frame));
    }
    if (!home_)
      refuse(
          "heights count from home, and the file has no home: give the height of the ground there");
    return *home_ + item.altitude;
  }

  // Where an item is; a take-off or landing at 0, 0 or null is where the vehicle is.
  Vec3 place(const MissionItem& item) const {
    const bool here = item.command == kTakeoff || item.command == kLand;
    const bool unsaid = std::isnan(item.latitude) || std::isnan(item.longitude) ||
                        (item.latitude == 0 && item.longitude == 0);
    if (here && unsaid) return above_here(height(item));
    if (!(std::abs(item.latitude) <= 90) || !(std::abs(item.longitude) <= 180)) {
      refuse(fmt::format("latitude and longitude must be within 90 and 180 degrees, found {} {}",
                         item.latitude, item.longitude));
    }
    return on_map({item.latitude, item.longitude, 0}, height(item));
  }

  Vec3 on_map(const geom::GeodeticPlace& at, double z) const {
    if (!is_near(frame_.origin, at.latitude, at.longitude)) {
      refuse(fmt::format("expected a place near the origin {} {}, found {} {}",
                         frame_.origin.latitude, frame_.origin.longitude, at.latitude,
                         at.longitude));
    }
    Vec3 p = earth_.enu(at);
    p.z() = z;
    return p;
  }

  Vec3 above_here(double z) const {
    if (!flown_.path.empty()) return {flown_.path.back().x(), flown_.path.back().y(), z};
    if (!mission_.home) refuse("expected a place of the take-off or of home, found neither");
    return on_map(*mission_.home, z);
  }

  void go(const Vec3& p, double hold) {
    if (!flown_.path.empty() && p != flown_.path.back()) {
      unsaid_speed_ = unsaid_speed_ || !flown_.speed;
      const bool passes = flown_.path.size() > 1 && flown_.hold.back() == 0;
      flown_.cuts_corners = flown_.cuts_corners || passes;
    }
    flown_.path.push_back(p);
    flown_.hold.push_back(hold);
  }

  double hold_of(const MissionItem& item) const {
    const double hold = std::isnan(item.param[0]) ? 0 : item.param[0];
    if (!(hold >= 0) || !std::isfinite(hold)) {
      refuse(fmt::format("a hold must be >= 0 s, found {}", hold));
    }
    return hold;
  }

  void take(const MissionItem& item) {
    const bool moves_nothing = std::find(std::begin(kMovesNothing), std::end(kMovesNothing),
                                         item.command) != std::end(kMovesNothing);
    if (moves_nothing) return;
    if (flown_.ended) {
      refuse(
          fmt::format("expected nothing after the end of the flight (a landing, a return, "
                      "loitering without end), found command {}",
                      item.command));
    }
    if (item.command == kTakeoff) {
      take_off(item);
    } else if (item.command == kWaypoint) {
      go(place(item), hold_of(item));
    } else if (item.command == kLoiterTime || item.command == kLoiterForever) {
      require_on_the_spot(item);
      const bool forever = item.command == kLoiterForever;
      go(place(item), forever ? 0 : hold_of(item));
      flown_.ended = forever;
    } else if (item.command == kLand) {
      land(item);
    } else {
      take_other(item);
    }
  }

  // Straight up: at home, where the file says both and they differ, and then to the place it says.
  void take_off(const MissionItem& item) {
    if (!flown_.path.empty()) {
      refuse("expected one take-off, at the beginning, found another command before it");
    }
    const Vec3 p = place(item);
    flown_.ends.takeoff_from = home_;
    if (mission_.home) {
      const Vec3 above_home = on_map(*mission_.home, p.z());
      const double away = (above_home - p).norm();
      if (away > kSamePlace) {
        flown_.takeoff_from_home = away;
        go(above_home, 1);  // it climbs to the height first
      }
    }
    go(p, 0);
  }

  void require_on_the_spot(const MissionItem& item) const {
    const double radius = item.param[2];
    if (radius == 0 || std::isnan(radius)) return;
    refuse(
        fmt::format("expected loitering on the spot (radius 0), found a circle of {} m", radius));
  }

  // On the ground at the height it says, from the height it comes with.
  void land(const MissionItem& item) {
    const Vec3 ground = place(item);
    if (flown_.path.empty()) refuse("expected a waypoint or a take-off before the landing");
    const Vec3 above(ground.x(), ground.y(), flown_.path.back().z());
    if (above != flown_.path.back()) go(above, 0);
    flown_.ends.landing_on = ground.z();
    flown_.ended = true;
  }

  void take_other(const MissionItem& item) {
    if (item.command == kReturn) {
      flown_.returns = flown_.ended = true;
    } else if (item.command == kSpeed) {
      take_speed(item.param[1]);
    } else if (item.command == kDelay) {
      if (!flown_.hold.empty()) flown_.hold.back() += hold_of(item);
    } else {
      refuse(
          fmt::format("expected waypoints (16), take-offs (22), landings (21), loitering (17, 19), "
                      "a return (20), delays (93), speeds (178) or what is known to move nothing, "
                      "found command {}",
                      item.command));
    }
  }

  // -1: as it is; other values that are no speed: the vehicle's own, which the file does not say.
  void take_speed(double speed) {
    if (speed > 0) {
      flown_.speed = std::max(flown_.speed.value_or(0), speed);
    } else if (speed != -1) {
      unsaid_speed_ = true;
    }
  }

  const Mission& mission_;
  const MissionFrame& frame_;
  geom::GeographicFrame earth_;
  std::optional<double> home_;
  std::string source_;
  std::size_t index_ = 0;
  bool unsaid_speed_ = false;  // a leg, the ascent aside, was flown before any speed was said
  FlownMission flown_;
};

}  // namespace

Mission make_mission(std::span<const Vec3> points, const MissionFrame& frame,
                     const MissionOptions& options) {
  const geom::GeographicFrame earth(frame.origin);
  Mission mission;
  const MissionItem takeoff = item_at(earth, kTakeoff, points.front(), options.home);
  const double sea_level = frame.origin.height - frame.geoid;
  mission.home = {takeoff.latitude, takeoff.longitude, to_millimetres(sea_level + options.home)};
  mission.items.push_back(takeoff);
  if (options.speed) {
    MissionItem speed;
    speed.frame = kMissionFrame;
    speed.command = kSpeed;
    speed.param = {1, *options.speed, -1, 0};  // over ground; throttle as it is
    mission.items.push_back(speed);
  }
  for (const Vec3& p : points.subspan(1)) {
    mission.items.push_back(item_at(earth, kWaypoint, p, options.home));
    mission.items.back().param = {options.hold, options.acceptance, 0, 0};
  }
  if (options.landing_on) {
    Vec3 ground = points.back();
    ground.z() = *options.landing_on;
    mission.items.push_back(item_at(earth, kLand, ground, options.home));
  }
  return mission;
}

bool is_near(const geom::GeodeticOrigin& origin, double latitude, double longitude) {
  return std::abs(latitude) <= 90 && std::abs(latitude - origin.latitude) <= 10 &&
         std::abs(std::remainder(longitude - origin.longitude, 360)) <= 20;
}

FlownMission flown_mission(const Mission& mission, const MissionFrame& frame,
                           std::optional<double> home, std::string_view source) {
  return Flight(mission, frame, home, source).fly();
}

}  // namespace traj
