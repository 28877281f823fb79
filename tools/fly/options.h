#pragma once

// The options of skyway-fly that say how to fly.

#include <CLI/CLI.hpp>
#include <string>

#include "cli/option/degrees.h"
#include "cli/option/vehicle_option.h"
#include "traj/flight/monte_carlo.h"
#include "traj/flight/tune.h"
#include "traj/tube/prove_tube.h"

namespace fly {

struct Options {
  std::string gains;         // "", a preset or a file
  std::string feed_forward;  // "", none, velocity or full
  traj::ControlLaw controller = traj::ControlLaw::cascade;
  std::string wind;
  std::string noise;
  std::string cost = "rms";
  double step = 0;  // s, 0: the loops' own periods
  double gusts = 0;
  double mass_error = 0;
  double delay = 0;
  double hover = 3;
  double settle = 3;
  double log_rate = 100;
  std::uint64_t seed = 0;
  int runs = 0;
  bool proved_tube = false;
  double wind_spread = 0;
  double gust_most = 0;
  double drag_error = 0;
  double motor_lag_error = 0;
  double inertia_error = 0;
  double gust_lag = 1;
  bool tube = false;
  bool tune = false;
  cli::MetresOption metres;

  void add_to(CLI::App& app);

  // Throws cli::UsageError for what cannot be flown.
  traj::FlightOptions flight(const traj::VehicleProfile& profile) const;
  traj::FlightCost flight_cost() const;
  traj::MonteCarloOptions spread() const;
  // What a tube is proved for. Throws cli::UsageError for flights that no proof speaks of.
  traj::Disturbances disturbances(const traj::FlightOptions& flight) const;
  int log_period() const;  // ms
};

}  // namespace fly
