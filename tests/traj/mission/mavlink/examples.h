#pragma once

// What tests of several drone files write and read back.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/reading.h"
#include "traj/curve/trajectory.h"
#include "traj/mission/mavlink/mission.h"

namespace traj::testing {

inline const MissionFrame kFrame{{37.79248, -122.39745, 12.5}, -32};
inline const std::vector<Vec3> kPoints = {{-315.25, 440.5, 20}, {10, -3, 31.25}, {250, 700, 8}};

inline MissionOptions mission_options() {
  MissionOptions o;
  o.home = 2;
  o.landing_on = 6.5;
  o.speed = 4.5;
  return o;
}

// An item of each kind that is written.
inline Mission every_item() {
  Mission mission;
  mission.home = geom::GeodeticPlace{47, 8, 410.5};
  mission.items = {{kGlobalRelative, kTakeoff, {0, 0, 0, 0}, 47, 8, 15},
                   {kMissionFrame, kSpeed, {1, 4.5, -1, 0}, 0, 0, 0},
                   {kGlobalRelative, kWaypoint, {2, 0.25, 0, 0}, 47.0012345, 8.0054321, 20.125},
                   {kGlobalRelative, kLand, {0, 0, 0, 0}, 47.0012345, 8.0054321, 0}};
  return mission;
}

inline void expect_same(const Mission& back, const Mission& mission) {
  ASSERT_TRUE(back.home);
  EXPECT_EQ(*back.home, *mission.home);
  ASSERT_EQ(back.items.size(), mission.items.size());
  for (std::size_t i = 0; i < mission.items.size(); ++i) {
    const MissionItem& a = back.items[i];
    const MissionItem& b = mission.items[i];
    EXPECT_EQ(a.frame, b.frame) << i;
    EXPECT_EQ(a.command, b.command) << i;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a.param[k], b.param[k]) << i;
    EXPECT_EQ(a.latitude, b.latitude) << i;
    EXPECT_EQ(a.longitude, b.longitude) << i;
    EXPECT_EQ(a.altitude, b.altitude) << i;
  }
}

// From rest over a joint in motion to rest.
inline Trajectory example() {
  const State a{{300.25, -120.5, 20}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const State b{{340, -100, 25}, {5, 1, 0.5}, {0.1, 0, 0}, Vec3::Zero()};
  const State c{{380, -130, 22}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  return {{hermite(a, b, 9.5), hermite(b, c, 11.25)}};
}

inline std::string refusal(const std::string& text, void (*read)(std::istream&)) {
  return support::refusal_of([&] { read(support::Text(text)); });
}

}  // namespace traj::testing
