#pragma once

// The options that name a vehicle's limits, and which limits hold then.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geom/vehicle/vehicle.h"
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

// geom::limits_that_hold for a check. UsageError where --override asks for more tilt than the
// vehicle's box holds.
geom::Limits limits_to_check(const geom::LimitSources& sources, const std::string& vehicle);

// Those to solve for: what is asked and what the vehicle may do. UsageError where more is asked
// than the vehicle may do, and where both say too little to solve for.
geom::Limits limits_to_solve(const geom::Limits& asked, const geom::Vehicle& vehicle);

}  // namespace cli
