#include "cli/limit_options.h"

#include <numbers>

namespace cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::optional<double> radians(const std::optional<double>& degrees) {
  return degrees ? std::optional(*degrees * kDegree) : std::nullopt;
}

}  // namespace

void LimitOptions::add_to(CLI::App& app) {
  const auto positive = [&](const char* name, std::optional<double>& value, const char* text) {
    app.add_option(name, value, text)->check(CLI::PositiveNumber);
  };
  positive("--vmax", given_.vmax, "largest speed, m/s");
  positive("--amax", given_.amax, "largest acceleration, m/s2");
  positive("--jmax", given_.jmax, "largest jerk, m/s3");
  positive("--vmax-h", given_.vmax_h, "largest horizontal speed, m/s");
  positive("--vmax-v", given_.vmax_v, "largest vertical speed, m/s");
  app.add_option("--tilt", tilt_, "largest tilt of the thrust from upright, degrees")
      ->check(CLI::Range(1.0, 80.0));
  app.add_option("--thrust", given_.thrust, "largest thrust over mass, m/s2 (above 9.80665)")
      ->check(CLI::Range(9.81, 1e4));
  app.add_option("--body-rate", body_rate_,
                 "largest rate at which the thrust turns (roll and pitch), degrees/s")
      ->check(CLI::Range(0.1, 1e5));
  app.add_option("--yaw-rate", yaw_rate_, "largest yaw rate, degrees/s")
      ->check(CLI::Range(0.1, 1e4));
}

traj::Limits LimitOptions::limits() const {
  traj::Limits out = given_;
  out.tilt = radians(tilt_);
  out.body_rate = radians(body_rate_);
  out.yaw_rate = radians(yaw_rate_);
  return out;
}

}  // namespace cli
