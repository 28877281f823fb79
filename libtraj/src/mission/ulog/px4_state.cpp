#include "mission/ulog/px4_state.h"

#include <cmath>

namespace traj {
namespace {

constexpr double kLargest = 1e6;  // m, m/s, rad/s: beyond that it is no flight

std::optional<Eigen::Quaterniond> attitude_of(const UlogMessage& message) {
  Eigen::Quaterniond out;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = message.number("q", i);
    if (!value) return std::nullopt;
    out.coeffs()[i == 0 ? 3 : static_cast<Eigen::Index>(i) - 1] = *value;  // the file: w, x, y, z
  }
  constexpr double kRounding = 1e-3;  // of single precision, and of their filter
  if (std::abs(out.norm() - 1) > kRounding) return std::nullopt;
  return out.normalized();
}

// Vectors are arrays since PX4 1.14, and three fields before.
Px4Setpoint setpoint_of(const UlogMessage& message) {
  const auto either = [&](const char* field, const char* x, const char* y, const char* z) {
    const auto vector = vector_of(message, field);
    return vector ? vector : vector_of(message, x, y, z);
  };
  return {either("position", "x", "y", "z"), either("velocity", "vx", "vy", "vz"),
          message.number("yaw")};
}

// Of four motors: with more or fewer it is another vehicle, which a flight log does not hold.
std::optional<std::array<double, 4>> motors_of(const UlogMessage& message) {
  std::array<double, 4> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto value = message.number("control", i);
    if (!value || *value < 0 || *value > 1) return std::nullopt;
    out[i] = *value;
  }
  if (message.number("control", out.size())) return std::nullopt;
  return out;
}

std::optional<geom::Vec3> vector_of(std::optional<double> x, std::optional<double> y,
                                    std::optional<double> z) {
  if (!x || !y || !z) return std::nullopt;
  const geom::Vec3 out(*x, *y, *z);
  return out.cwiseAbs().maxCoeff() <= kLargest ? std::optional(out) : std::nullopt;
}

std::optional<double> battery_of(const UlogMessage& message) {
  const auto share = message.number("remaining");
  const bool there = message.flag("connected").value_or(true);
  return share && there && *share >= 0 && *share <= 1 ? share : std::nullopt;
}

}  // namespace

std::optional<geom::Vec3> vector_of(const UlogMessage& message, const char* x, const char* y,
                                    const char* z) {
  return vector_of(message.number(x), message.number(y), message.number(z));
}

std::optional<geom::Vec3> vector_of(const UlogMessage& message, const char* field) {
  return vector_of(message.number(field, 0), message.number(field, 1), message.number(field, 2));
}

void Px4State::take(const UlogMessage& message) {
  const std::string_view topic = message.topic();
  const std::uint64_t time = message.timestamp();
  if (topic == "vehicle_attitude") {
    attitude.set(time, attitude_of(message));
    const auto rates = vector_of(message, "rollspeed", "pitchspeed", "yawspeed");  // to PX4 1.10
    if (rates) body_rates.set(time, rates);
  } else if (topic == "vehicle_angular_velocity") {
    body_rates.set(time, vector_of(message, "xyz"));
  } else if (topic == "trajectory_setpoint") {
    setpoint.set(time, setpoint_of(message));
  } else if (topic == "vehicle_local_position_setpoint") {
    local_setpoint.set(time, setpoint_of(message));
  } else if (topic == "battery_status") {
    battery.set(time, battery_of(message));
  } else if (topic == "actuator_motors") {
    motors.set(time, motors_of(message));
  }
}

}  // namespace traj
