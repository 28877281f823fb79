#include <algorithm>
#include <cmath>

#include "dji_waylines.h"
#include "traj/mission/dji/dji_mission.h"

namespace traj {
namespace {

constexpr double kLeastSecurity = 2;    // m, of takeOffSecurityHeight
constexpr double kMostSecurity = 1500;  // m
constexpr double kUsualSpeed = 5;       // m/s
constexpr double kLegShare = 0.45;      // that a turn which is written may take

double to_1e9(double degrees) { return std::round(degrees * 1e9) / 1e9; }
double to_millimetres(double metres) { return std::round(metres * 1e3) / 1e3; }

// How far before a point it may turn, on legs that have room for it.
double room_to_turn(std::span<const geom::Vec3> points, std::size_t i, double most) {
  const double before = (points[i] - points[i - 1]).norm();
  const double behind = (points[i + 1] - points[i]).norm();
  return std::floor(100 * std::min(most, kLegShare * std::min(before, behind))) / 100;
}

const char* action_of(DjiLostLink lost_link) {
  switch (lost_link) {
    case DjiLostLink::go_back:
      return "goBack";
    case DjiLostLink::go_on:
      return "goContinue";
    case DjiLostLink::land:
      return "landing";
    case DjiLostLink::hover:
      return "hover";
  }
  return "";
}

}  // namespace

DjiMission make_dji_mission(std::span<const geom::Vec3> points, const MissionFrame& frame,
                            const DjiOptions& options) {
  const geom::GeographicFrame earth(frame.origin);
  const double speed = std::min(options.speed.value_or(kUsualSpeed), kDjiFastest);
  DjiWayline wayline;
  for (const geom::Vec3& p : points) {
    const geom::GeodeticPlace place = earth.place(p);
    wayline.waypoints.push_back({to_1e9(place.latitude), to_1e9(place.longitude),
                                 to_millimetres(p.z() - options.home), speed});
  }
  for (std::size_t i = 1; i + 1 < std::min(points.size(), options.turns.size()); ++i) {
    const double damping = room_to_turn(points, i, options.turns[i]);
    if (damping < kDjiLeastTurn) continue;
    wayline.waypoints[i].turn = DjiTurn::early;
    wayline.waypoints[i].damping = damping;
  }
  const DjiWaypoint& first = wayline.waypoints.front();
  DjiMission mission;
  mission.version = options.version;
  mission.aircraft = options.aircraft;
  mission.finish = options.lands ? DjiFinish::land : DjiFinish::hover;
  mission.security_height = std::clamp(first.height, kLeastSecurity, kMostSecurity);
  mission.transit_speed = std::max(speed, kDjiSlowestTransit);
  mission.without_link = action_of(options.lost_link);
  mission.gimbal = options.gimbal;
  mission.nose = options.nose;
  const double home_height = to_millimetres(frame.origin.height + options.home);
  mission.takeoff = {first.latitude, first.longitude, home_height};
  if (options.takeoff) {
    const geom::GeodeticPlace stands = earth.place(*options.takeoff);
    mission.takeoff = {to_1e9(stands.latitude), to_1e9(stands.longitude), home_height};
  }
  mission.waylines.push_back(std::move(wayline));
  return mission;
}

}  // namespace traj
