#pragma once

// Missions about one home, and where they are flown.

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "geom/shape/hull.h"
#include "support/reading.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace traj::testing {

inline const MissionFrame kHomeFrame{{47, 8, 400}, 0};

inline const MissionRules kArduPilot{.autopilots = {ardupilot()}};
inline const MissionRules kPx4{.autopilots = {px4()}};

// A mission about (47, 8), home on the ground at z 10. Places in metres from there.
class MissionMaker {
 public:
  MissionMaker() {
    mission_.home = geom::GeodeticPlace{47, 8, 410};
    add(kTakeoff, {0, 0, 30});
  }

  MissionMaker& add(int command, const Vec3& at, std::array<double, 4> param = {}) {
    const geom::GeodeticPlace place = earth_.place(at);
    MissionItem item;
    item.command = command;
    item.param = param;
    item.latitude = place.latitude;
    item.longitude = place.longitude;
    item.altitude = at.z() - 10;
    item.number = mission_.items.size() + 1;
    mission_.items.push_back(item);
    return *this;
  }

  // An item without a place.
  MissionMaker& just(int command, std::array<double, 4> param = {}) {
    add(command, Vec3(0, 0, 10), param);
    mission_.items.back().latitude = mission_.items.back().longitude = 0;
    mission_.items.back().frame = kMissionFrame;
    return *this;
  }

  // A landing where it is, which the file says by null.
  MissionMaker& land_here() {
    just(kLand);
    MissionItem& item = mission_.items.back();
    item.latitude = item.longitude = std::numeric_limits<double>::quiet_NaN();
    item.frame = kGlobalRelative;
    return *this;
  }

  FlownMavlink fly(const MissionRules& rules = {}, const MissionFrame& frame = kHomeFrame) const {
    return flown_mission(mission_, frame, rules, "m");
  }

  std::string refusal(const MissionRules& rules = {},
                      const MissionFrame& frame = kHomeFrame) const {
    return support::refusal_of([&] { fly(rules, frame); });
  }

  Mission& mission() { return mission_; }

 private:
  Mission mission_;
  geom::GeographicFrame earth_{kHomeFrame.origin};
};

inline bool holds(const std::vector<Vec3>& hull, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(1e-6);
  return geom::hull_meets(hull, {p - hair, p + hair}).has_value();
}

// Whether one of the sweeps of that kind holds the point.
inline bool swept(const FlownMavlink& flown, Manoeuvre manoeuvre, const Vec3& p) {
  for (const Sweep& sweep : flown.sweeps) {
    if (sweep.part.manoeuvre == manoeuvre && holds(sweep.hull, p)) return true;
  }
  return false;
}

inline void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_LT((a - b).norm(), 1e-6) << a.transpose();
}

}  // namespace traj::testing
