#pragma once

// The options that name a vehicle's limits.

#include <CLI/CLI.hpp>
#include <optional>

#include "traj/limits.h"

namespace cli {

// Options of their own for what is limited; angles are degrees there and radians here.
class LimitOptions {
 public:
  void add_to(CLI::App& app);
  traj::Limits limits() const;  // those that were given

 private:
  traj::Limits given_;
  std::optional<double> tilt_;
  std::optional<double> body_rate_;
  std::optional<double> yaw_rate_;
};

}  // namespace cli
