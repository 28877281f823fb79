#include "traj/flight/wind.h"

#include <algorithm>

namespace traj {
namespace {

using geom::Vec3;

constexpr double kFoot = 0.3048;
constexpr double kSlowest = 0.5;  // m/s of air speed: slower, turbulence is not frozen

}  // namespace

DrydenScales dryden_scales(double height, double speed_at_20_feet) {
  const double h = std::clamp(height / kFoot, 10.0, 1000.0);
  const double shape = 0.177 + 0.000823 * h;
  const double up = 0.1 * speed_at_20_feet;
  const double across = up / std::pow(shape, 0.4);
  const double length = h / std::pow(shape, 1.2) * kFoot;
  return {{across, across, up}, {length, length, h * kFoot}};
}

Gusts::Gusts(double speed_at_20_feet, std::uint64_t seed) : speed_(speed_at_20_feet), noise_(seed) {
  // Stationary from the start: E[a a] = 1/2, E[a b] = E[b b] = 1/4 of the second-order states.
  first_ = noise_.vector() * std::sqrt(0.5);
  second_ = first_ * 0.5 + noise_.vector() * std::sqrt(0.125);
  first_.x() *= std::sqrt(2.0);
}

// With l = V / L: a' = -l a + white, b' = -l b + l a, and sqrt(3) a + (1 - sqrt(3)) b has the
// spectrum of (1 + sqrt(3) s/l) / (1 + s/l)^2 and variance 1; each step draws from the exact
// covariance of the noise gathered meanwhile.
Vec3 Gusts::step(double height, double air_speed, double dt) {
  const DrydenScales scales = dryden_scales(height, speed_);
  const double v = std::max(air_speed, kSlowest);
  Vec3 out;
  for (int k = 0; k < 3; ++k) {
    const double x = v / scales.length[k] * dt;
    const double e = std::exp(-x);
    const double n = noise_.next();
    if (k == 0) {
      first_[0] = e * first_[0] + std::sqrt(-std::expm1(-2 * x)) * n;
      out[0] = scales.deviation[0] * first_[0];
      continue;
    }
    const double q11 = -std::expm1(-2 * x) / 2;
    const double q12 = (1 - e * e * (1 + 2 * x)) / 4;
    const double q22 = (1 - e * e * (1 + 2 * x + 2 * x * x)) / 4;
    const double l11 = std::sqrt(q11);
    const double l21 = q12 / l11;
    second_[k] = e * (second_[k] + x * first_[k]) + l21 * n +
                 std::sqrt(std::max(0.0, q22 - l21 * l21)) * noise_.next();
    first_[k] = e * first_[k] + l11 * n;
    out[k] = scales.deviation[k] * (std::sqrt(3.0) * first_[k] + (1 - std::sqrt(3.0)) * second_[k]);
  }
  return out;
}

Wind::Wind(const WindSpec& spec, std::uint64_t seed) : spec_(spec), gusts_(spec.gusts, seed) {
  along_ = Vec3(spec.mean.x(), spec.mean.y(), 0);
  along_ = along_.norm() > 0 ? Vec3(along_.normalized()) : Vec3::UnitX();
}

Vec3 Wind::step(const Vec3& position, const Vec3& velocity, double dt) {
  if (spec_.gusts == 0) return spec_.mean;
  const Vec3 gust = gusts_.step(position.z(), (velocity - spec_.mean).norm(), dt);
  const Vec3 across(-along_.y(), along_.x(), 0);
  return spec_.mean + gust.x() * along_ + gust.y() * across + gust.z() * Vec3::UnitZ();
}

}  // namespace traj
