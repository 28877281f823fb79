#include "traj/mission/mavlink/mission.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace traj {
namespace {

constexpr MavCommand kMovesNothing[] = {
    kConditionDelay, kConditionDistance, kConditionYaw,    kSetRelay,
    kRepeatRelay,    kSetServo,          kRepeatServo,     kLandingStart,
    kLookAtPlace,    kLookAtNext,        kLookAtNothing,   kControlVideo,
    kLookAt,         kConfigureCamera,   kControlCamera,   kConfigureMount,
    kControlMount,   kTriggerByDistance, kEnableFence,     kGripper,
    kTriggerByTime,  kCameraMode,        kCameraZoom,      kCameraFocus,
    kJumpTag,        kGimbalAngles,      kConfigureGimbal, kStartImages,
    kStopImages,     kControlTrigger,    kStartVideo,      kStopVideo};

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

class MissionMaker {
 public:
  MissionMaker(std::span<const Vec3> points, const MissionFrame& frame,
               const MissionOptions& options)
      : points_(points), frame_(frame), options_(options), earth_(frame.origin) {}

  Mission make() {
    const MissionItem takeoff = at(kTakeoff, points_.front());
    const double sea = frame_.sea_level(takeoff.latitude, takeoff.longitude);
    mission_.home = {takeoff.latitude, takeoff.longitude,
                     to_millimetres(frame_.origin.height - sea + options_.home)};
    mission_.items.push_back(takeoff);
    if (options_.speed) fly_with(*options_.speed);
    for (point_ = 0; point_ < points_.size(); ++point_) go();
    if (options_.landing_on) {
      Vec3 ground = points_.back();
      ground.z() = *options_.landing_on;
      mission_.items.push_back(at(kLand, ground));
      mission_.items.back().point = points_.size() - 1;
    }
    return std::move(mission_);
  }

 private:
  MissionItem at(int command, const Vec3& p) const {
    return item_at(earth_, command, p, options_.home);
  }

  void fly_with(double speed) {
    MissionItem item;
    item.frame = kMissionFrame;
    item.command = kSpeed;
    item.param = {1, speed, -1, 0};  // over ground; throttle as it is
    item.point = point_;
    mission_.items.push_back(item);
  }

  void add_waypoint(const Vec3& p, double hold) {
    mission_.items.push_back(at(kWaypoint, p));
    mission_.items.back().param = {hold, options_.acceptance, 0, 0};
    mission_.items.back().point = point_;
  }

  void go() {
    const Vec3& p = points_[point_];
    const bool end = point_ == 0 || point_ + 1 == points_.size();
    const bool passed = !end && !options_.passed.empty() && options_.passed[point_];
    const double slow = options_.approach.empty() ? 0 : options_.approach[point_];
    const bool slows = slow > 0 && options_.speed && point_ > 0;
    if (slows) {
      const Vec3 way = p - points_[point_ - 1];
      const double length = way.norm();
      if (length > 1.5 * options_.slowing) add_waypoint(p - way * (options_.slowing / length), 0);
      fly_with(slow);
    }
    add_waypoint(p, passed ? 0 : options_.hold);
    if (slows && point_ + 1 < points_.size()) fly_with(*options_.speed);
  }

  std::span<const Vec3> points_;
  const MissionFrame& frame_;
  const MissionOptions& options_;
  geom::GeographicFrame earth_;
  std::size_t point_ = 0;
  Mission mission_;
};

}  // namespace

bool moves_nothing(int command) {
  return std::find(std::begin(kMovesNothing), std::end(kMovesNothing), command) !=
         std::end(kMovesNothing);
}

Mission make_mission(std::span<const Vec3> points, const MissionFrame& frame,
                     const MissionOptions& options) {
  return MissionMaker(points, frame, options).make();
}

}  // namespace traj
