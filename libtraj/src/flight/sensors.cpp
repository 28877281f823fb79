#include "traj/flight/sensors.h"

#include <cmath>

namespace traj {

Sensors::Sensors(const SensorSpec& spec, const QuadrotorState& start, std::uint64_t seed)
    : spec_(spec), noise_(seed) {
  const auto steps = static_cast<std::size_t>(std::lround(spec.delay * 1e3));
  late_.assign(steps + 1, Fix{start.position, start.velocity});
}

Measured Sensors::read(const QuadrotorState& state) {
  late_[at_] = {state.position, state.velocity};
  at_ = at_ + 1 == late_.size() ? 0 : at_ + 1;  // the oldest, which the next reading replaces
  Measured out{late_[at_].position, late_[at_].velocity, state.attitude, state.body_rates};
  if (spec_.position > 0) out.position += spec_.position * noise_.vector();
  if (spec_.velocity > 0) out.velocity += spec_.velocity * noise_.vector();
  if (spec_.rates > 0) out.body_rates += spec_.rates * noise_.vector();
  if (spec_.attitude > 0) {
    const Vec3 half = 0.5 * spec_.attitude * noise_.vector();
    out.attitude =
        (state.attitude * Eigen::Quaterniond(1, half.x(), half.y(), half.z())).normalized();
  }
  return out;
}

}  // namespace traj
