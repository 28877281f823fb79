#include "options.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/option/numbers_option.h"
#include "cli/run.h"

namespace fly {
namespace {

traj::SensorSpec sensors(const std::string& noise, double delay) {
  traj::SensorSpec spec = cli::sensors_from("--noise", noise);
  spec.delay = cli::whole_milliseconds("--delay", delay) * 1e-3;
  return spec;
}

}  // namespace

void Options::add_to(CLI::App& app) {
  flown.add_to(app);
  app.add_option("--gusts", gusts,
                 "Dryden gusts for this wind speed at a height of 20 feet, m/s (default: 0)")
      ->check(CLI::Range(0.0, 50.0));
  app.add_option("--noise", noise,
                 "standard deviations of measured position, velocity, attitude and body rates: "
                 "metres, m/s, degrees, degrees/s")
      ->type_name("P,V,A,R");
  app.add_option("--delay", delay,
                 "how late the measured position and velocity are, s (default: 0)")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--log-rate", log_rate,
                 "rows a second: 100 divided by a whole number (default: 100)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--seed", seed, "seed of gusts, noise and runs (default: 0)");
  app.add_option("--runs", runs, "fly this many times more, with wind and mass by chance")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--proved-tube", proved_tube,
               "prove how far the vehicle strays at most, in all allowed winds, gusts and masses");
  app.add_flag("--clear-tube", tube,
               "with a map: ask whether it is clear with the tube of --runs or --proved-tube");
  app.add_flag("--tune", tune, "write gains found for these trajectories instead of a log");
  app.add_option(
      "--cost", cost,
      "what --tune makes small: mean, rms, p99, max, final, saturated, each with a weight, as "
      "mean:1,max:0.5 (default: rms); or proved-tube, the largest radius of a proved tube");
  metres.add_to(app);
}

traj::FlightOptions Options::flight(const traj::VehicleProfile& profile) const {
  traj::FlightOptions out = flown.flight(profile);
  out.wind.gusts = gusts;
  out.sensors = sensors(noise, delay);
  out.seed = seed;
  return out;
}

traj::FlightCost Options::flight_cost() const {
  traj::FlightCost out;
  out.rms = 0;
  std::size_t at = 0;
  while (at <= cost.size()) {
    const std::size_t end = std::min(cost.find(',', at), cost.size());
    const std::string term = cost.substr(at, end - at);
    const std::size_t colon = std::min(term.find(':'), term.size());
    const std::string name = term.substr(0, colon);
    const auto weight = colon < term.size() ? cli::parse_numbers(term.substr(colon + 1), 1)
                                            : std::vector<double>{1};
    double* value = name == "mean"        ? &out.mean
                    : name == "rms"       ? &out.rms
                    : name == "p99"       ? &out.p99
                    : name == "max"       ? &out.largest
                    : name == "final"     ? &out.final_distance
                    : name == "saturated" ? &out.saturated
                                          : nullptr;
    if (!value || !weight || weight->front() < 0) {
      throw cli::UsageError(fmt::format(
          "--cost: expected mean, rms, p99, max, final or saturated with a weight >= 0, as "
          "mean:1,max:0.5, found \"{}\"",
          term));
    }
    *value = weight->front();
    at = end + 1;
  }
  return out;
}

traj::MonteCarloOptions Options::spread() const { return {runs, std::abs(flown.mass_error)}; }

int Options::log_period() const {
  const double samples = 100 / log_rate;
  if (std::abs(samples - std::round(samples)) > 1e-9) {
    throw cli::UsageError(
        fmt::format("--log-rate: expected 100 over a whole number, found {}", log_rate));
  }
  return static_cast<int>(std::lround(samples)) * 10;
}

}  // namespace fly
