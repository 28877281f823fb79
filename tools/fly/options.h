#pragma once

// The options of skyway-fly that say how to fly.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "cli/option/degrees.h"
#include "cli/option/simulated_vehicle.h"
#include "cli/option/vehicle_option.h"
#include "traj/flight/monte_carlo.h"
#include "traj/flight/tune.h"

namespace fly {

// --cost, for the least proved tube.
inline constexpr std::string_view kTubeCost = "proved-tube";

struct Options {
  cli::SimulatedVehicleOptions flown;
  std::string noise;
  std::string cost = "rms";
  double gusts = 0;
  double delay = 0;
  double log_rate = 100;
  std::uint64_t seed = 0;
  int runs = 0;
  bool proved_tube = false;
  bool tube = false;
  bool tune = false;
  cli::MetresOption metres;

  void add_to(CLI::App& app);

  // Throws cli::UsageError for what cannot be flown.
  traj::FlightOptions flight(const traj::VehicleProfile& profile) const;
  traj::FlightCost flight_cost() const;
  bool tunes_tube() const { return tune && cost == kTubeCost; }
  // Whether a tube is proved, once or for many gains.
  bool proves() const { return proved_tube || tunes_tube(); }
  traj::MonteCarloOptions spread() const;
  int log_period() const;  // ms
};

}  // namespace fly
