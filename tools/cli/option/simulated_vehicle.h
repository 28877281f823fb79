#pragma once

// How a simulated vehicle is flown and what may disturb it, for tools that fly it or prove its
// tube.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "traj/flight/simulate.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/tube/prove_tube.h"

namespace cli {

struct SimulatedVehicleOptions {
  std::string gains;         // "", a preset or a file
  std::string feed_forward;  // "", none, velocity or full
  traj::ControlLaw controller = traj::ControlLaw::cascade;
  double step = 0;  // s, 0: the loops' own periods
  std::string wind;
  double mass_error = 0;
  double hover = 3;
  double settle = 3;
  double wind_spread = 0;
  double gust_most = 0;
  double gust_lag = 1;
  double start_error = 0;
  double start_speed = 0;
  double drag_error = 0;
  double motor_lag_error = 0;
  double inertia_error = 0;
  double gain_error = 0;
  std::string noise_most;

  void add_to(CLI::App& app);
  // Throw UsageError where one was given and nothing heeds it: any option of a tool that does not
  // fly, those of disturbances that only a proof knows.
  static void refuse_idle(const CLI::App& app, bool flies, std::string_view to_what);
  static void refuse_idle_disturbances(const CLI::App& app, bool proves);

  // Without noise, delay and gusts by chance. Throws cli::UsageError for what cannot be flown.
  traj::FlightOptions flight(const traj::VehicleProfile& profile) const;
  // What a tube is proved for. Throws cli::UsageError for flights that no proof speaks of.
  traj::Disturbances disturbances(const traj::FlightOptions& flight) const;
};

// Four numbers >= 0 of an option: metres, m/s, degrees, degrees/s, in SI; nothing if there is no
// text. Throws cli::UsageError for anything else.
traj::SensorSpec sensors_from(const char* flag, const std::string& text);

// A whole number of them. Throws cli::UsageError for another.
int whole_milliseconds(const char* flag, double seconds);

}  // namespace cli
