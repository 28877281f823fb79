#include "traj/drone_file/mission.h"

#include <cmath>

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

}  // namespace traj
