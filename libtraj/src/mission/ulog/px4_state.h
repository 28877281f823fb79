#pragma once

// What a PX4 vehicle logged last, topic by topic, in its own axes: north, east, down; x forward, y
// right, z down.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>

#include "geom/base/vec3.h"
#include "traj/mission/ulog/ulog_reader.h"

namespace traj {

// A value and when it was logged.
template <class Value>
class Logged {
 public:
  void set(std::uint64_t time, const std::optional<Value>& value) {
    time_ = time;
    value_ = value;
  }

  // The value, if it is at most 1 s old then.
  std::optional<Value> at(std::uint64_t time) const {
    constexpr std::uint64_t kOldest = 1'000'000;  // microseconds
    const std::uint64_t age = time > time_ ? time - time_ : time_ - time;
    return age <= kOldest ? value_ : std::nullopt;
  }

 private:
  std::uint64_t time_ = 0;
  std::optional<Value> value_;
};

struct Px4Setpoint {
  std::optional<geom::Vec3> position;
  std::optional<geom::Vec3> velocity;
  std::optional<double> yaw;  // rad clockwise from north
};

struct Px4State {
  Logged<Eigen::Quaterniond> attitude;  // turns body axes into north, east, down
  Logged<geom::Vec3> body_rates;
  Logged<Px4Setpoint> setpoint;        // trajectory_setpoint
  Logged<Px4Setpoint> local_setpoint;  // vehicle_local_position_setpoint
  Logged<double> battery;              // share that is left
  Logged<std::array<double, 4>> motors;

  void take(const UlogMessage& message);
};

// A vector of three fields, or of an array's first three; nothing where one of them is
// not known or beyond 1e6.
std::optional<geom::Vec3> vector_of(const UlogMessage& message, const char* x, const char* y,
                                    const char* z);
std::optional<geom::Vec3> vector_of(const UlogMessage& message, const char* field);

}  // namespace traj
