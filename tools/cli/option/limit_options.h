#pragma once

// The options that name a vehicle's limits.

#include <CLI/CLI.hpp>
#include <optional>

#include "traj/proof/limits.h"

namespace cli {

// Options of their own for what is limited; angles are degrees there and radians in what limits()
// gives.
class LimitOptions {
 public:
  void add_to(CLI::App& app);
  traj::Limits limits() const;  // those that were given; UsageError for one that is no number

 private:
  geom::PerLimit<std::optional<double>> given_;  // in the options' units
};

}  // namespace cli
