#include "traj/flight/model_hash.h"

#include <vector>

#include "geom/base/sha256.h"
#include "traj/flight/gains_record.h"

namespace traj {
namespace {

std::vector<double> numbers_of(const Quadrotor& quadrotor) {
  std::vector<double> out{quadrotor.mass,
                          quadrotor.arm.x(),
                          quadrotor.arm.y(),
                          quadrotor.torque_per_thrust,
                          quadrotor.motor_least,
                          quadrotor.motor_most,
                          quadrotor.motor_time_constant};
  for (const Vec3& v : {quadrotor.inertia, quadrotor.drag, quadrotor.body_rate_max}) {
    out.insert(out.end(), v.begin(), v.end());
  }
  return out;
}

}  // namespace

std::string model_hash(const FlightOptions& options) {
  std::vector<double> numbers = numbers_of(options.quadrotor);
  numbers.push_back(options.periods.position);
  numbers.push_back(options.periods.attitude);
  const std::string gains = to_json(options.gains);
  const std::string_view law = geom::word_of(kControlLawWords, options.law);
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(numbers)));
  sum.update(std::as_bytes(std::span(law)));
  sum.update(std::as_bytes(std::span(gains)));
  return sum.hex();
}

}  // namespace traj
