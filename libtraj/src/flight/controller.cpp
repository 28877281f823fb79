#include "traj/flight/controller.h"

#include <cmath>
#include <utility>

#include "flight/attitude.h"
#include "flight/motor_mixer.h"
#include "traj/curve/flatness.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

constexpr double kVelocityFilter = 1 / (2 * 3.141592653589793 * 5);  // s: PX4's MPC_VELD_LP, 5 Hz
constexpr double kRateFilter = 1 / (2 * 3.141592653589793 * 30);     // s: IMU_DGYRO_CUTOFF, 30 Hz
constexpr double kYawWeight = 0.4;                                   // PX4's MC_YAW_WEIGHT
constexpr double kLeastLift = 0.3 * kGravity;                        // m/s2: never falls freely

}  // namespace

CascadeController::CascadeController(const Quadrotor& model, const Gains& gains,
                                     const LoopPeriods& periods)
    : model_(model),
      gains_(gains),
      periods_(periods),
      position_(gains.position, periods.position * 1e-3, 0),
      velocity_(gains.velocity, periods.position * 1e-3, kVelocityFilter),
      rates_(gains.rates, 1e-3, kRateFilter) {}

Motors CascadeController::command(long step, const Reference& reference, const Measured& measured) {
  if (step % periods_.position == 0) follow(reference, measured);
  if (step % periods_.attitude == 0) orient(reference, measured);
  return turn(measured);
}

bool CascadeController::take_saturated() { return std::exchange(saturated_, false); }

// Position and velocity: what thrust over mass is wanted.
void CascadeController::follow(const Reference& reference, const Measured& measured) {
  const Vec3 wanted =
      position_.update(reference.position - measured.position,
                       gains_.feed_forward.velocity * reference.velocity, lost_velocity_);
  const Vec3 acceleration = velocity_.update(
      wanted - measured.velocity, gains_.feed_forward.acceleration * reference.acceleration,
      lost_acceleration_);
  lift_ = limited_lift(acceleration);
  lost_acceleration_ = acceleration + kGravity * Vec3::UnitZ() - lift_;
  // A velocity that the velocity loop cannot reach must not wind up the position's integral.
  lost_velocity_ = velocity_.clipped() ? lost_acceleration_ : Vec3::Zero();
  saturated_ |= position_.clipped() || velocity_.clipped() || !lost_acceleration_.isZero(1e-12);
}

// acceleration + g within the motors' thrust and the tilt, the vertical first (PX4 likewise).
Vec3 CascadeController::limited_lift(const Vec3& acceleration) {
  const double most = 4 * model_.motor_most / model_.mass;
  Vec3 lift = acceleration + kGravity * Vec3::UnitZ();
  lift.z() = std::clamp(lift.z(), std::min(kLeastLift, most), most);
  const double across = std::hypot(lift.x(), lift.y());
  const double room = std::min(std::sqrt(std::max(0.0, most * most - lift.z() * lift.z())),
                               lift.z() * std::tan(gains_.tilt_max));
  if (across > room) lift.head<2>() *= room / across;
  return lift;
}

// Attitude: what body rates are wanted.
void CascadeController::orient(const Reference& reference, const Measured& measured) {
  const Eigen::Quaterniond wanted(attitude_along(lift_, reference.yaw));
  const Vec3 error = attitude_error(measured.attitude, wanted, kYawWeight);
  const Vec3 forward = body_rates_along(lift_, reference.jerk, {reference.yaw, reference.yaw_rate});
  const Vec3 rates = gains_.attitude.cwiseProduct(error) + gains_.feed_forward.body_rates * forward;
  rate_reference_ = rates.cwiseMax(-model_.body_rate_max).cwiseMin(model_.body_rate_max);
  saturated_ |= rate_reference_ != rates;
}

// Body rates: what torques, and so what motors.
Motors CascadeController::turn(const Measured& measured) {
  const Vec3& w = measured.body_rates;
  const Vec3 slope = (last_rates_ - w) / 1e-3;  // of the error, the reference's left out
  last_rates_ = w;
  const Vec3 spin_up = rates_.update(rate_reference_ - w, slope, Vec3::Zero(), lost_turn_);
  const Vec3 torque =
      model_.inertia.cwiseProduct(spin_up) + w.cross(model_.inertia.cwiseProduct(w));
  const Mixed mixed = mix(model_, model_.mass * lift_.norm(), torque);
  lost_turn_ = (torque - mixed.torque).cwiseQuotient(model_.inertia);
  saturated_ |= mixed.saturated;
  return mixed.command;
}

}  // namespace traj
