#include "flight/geometric_controller.h"

#include <utility>

#include "flight/motor_mixer.h"
#include "traj/curve/flatness.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

constexpr double kPeriod = 1e-3;                              // s
constexpr double kFilter = 1 / (2 * 3.141592653589793 * 30);  // s: as the cascade's rate loop

Vec3 vee(const Eigen::Matrix3d& m) { return {m(2, 1), m(0, 2), m(1, 0)}; }

}  // namespace

GeometricController::GeometricController(const Quadrotor& model, const Gains& gains,
                                         const LoopPeriods& periods)
    : model_(model), gains_(gains), period_(periods.attitude) {}

bool GeometricController::take_saturated() { return std::exchange(saturated_, false); }

Motors GeometricController::command(long step, const Reference& reference,
                                    const Measured& measured) {
  const GeometricGains& k = gains_.geometric;
  if (step % period_ == 0) {
    lift_ = k.position.cwiseProduct(reference.position - measured.position) +
            k.velocity.cwiseProduct(reference.velocity - measured.velocity) +
            reference.acceleration + kGravity * Vec3::UnitZ();
    if (lift_.norm() < 1e-3) lift_ = 1e-3 * Vec3::UnitZ();  // eq. 14 asks for a direction
    wanted_ = attitude_along(lift_, reference.yaw);
    wanted_rates_ = body_rates_along(lift_, reference.jerk, {reference.yaw, reference.yaw_rate});
  }
  const Eigen::Matrix3d r = measured.attitude.toRotationMatrix();
  const Vec3& w = measured.body_rates;
  const Eigen::Matrix3d towards = r.transpose() * wanted_;
  const Vec3 attitude_error = 0.5 * vee(towards.transpose() - towards);  // eq. 10
  const Vec3 rate_error = w - towards * wanted_rates_;                   // eq. 11
  angular_acceleration_ +=
      kPeriod / (kPeriod + kFilter) * ((w - last_rates_) / kPeriod - angular_acceleration_);
  last_rates_ = w;
  const Vec3 spin_up = -k.attitude.cwiseProduct(attitude_error) - k.rates.cwiseProduct(rate_error) -
                       k.lead.cwiseProduct(angular_acceleration_);
  const Vec3 follow = w.cross(Vec3(towards * wanted_rates_));
  const Vec3& j = model_.inertia;
  const Vec3 torque =
      j.cwiseProduct(spin_up) + w.cross(j.cwiseProduct(w)) - j.cwiseProduct(follow);  // eq. 16
  const Mixed mixed = mix(model_, model_.mass * lift_.dot(r.col(2)), torque);         // eq. 15
  saturated_ |= mixed.saturated;
  return mixed.command;
}

}  // namespace traj
