#include "options.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/word_for.h"
#include "cli/run.h"
#include "geom/text/json_fields.h"
#include "traj/flight/gains_record.h"

namespace fly {
namespace {

traj::Gains gains_from(const std::string& word, const traj::Gains& own) {
  if (word.empty()) return own;
  if (const auto preset = traj::preset_gains(word, own)) return *preset;
  if (!word.ends_with(".json")) {
    throw cli::UsageError(
        fmt::format("--gains: expected stack-a, stack-b or FILE.json, found \"{}\"", word));
  }
  cli::InputFile file(word);
  const geom::JsonFields fields(file.read_all(), word, 0);
  if (!fields.has("gains")) fields.refuse({.expected = "the key \"gains\"", .found = "none"});
  return traj::parse_gains(fields, own);
}

std::vector<double> numbers(const char* flag, const std::string& text, std::size_t count,
                            const char* expected) {
  const auto values = cli::parse_numbers(text, count);
  if (!values) {
    throw cli::UsageError(fmt::format("{}: expected {}, found \"{}\"", flag, expected, text));
  }
  return *values;
}

int milliseconds(const char* flag, double seconds) {
  const double count = seconds * 1e3;
  if (std::abs(count - std::round(count)) > 1e-6) {
    throw cli::UsageError(
        fmt::format("{}: expected a whole number of milliseconds, found {} s", flag, seconds));
  }
  return static_cast<int>(std::lround(count));
}

traj::SensorSpec sensors(const std::string& noise, double delay) {
  traj::SensorSpec spec;
  spec.delay = milliseconds("--delay", delay) * 1e-3;
  if (noise.empty()) return spec;
  const char* expected = "four deviations >= 0: metres, m/s, degrees, degrees/s";
  const auto v = numbers("--noise", noise, 4, expected);
  if (*std::min_element(v.begin(), v.end()) < 0) {
    throw cli::UsageError(fmt::format("--noise: expected {}, found \"{}\"", expected, noise));
  }
  constexpr double radian = std::numbers::pi / 180;
  spec.position = v[0];
  spec.velocity = v[1];
  spec.attitude = v[2] * radian;
  spec.rates = v[3] * radian;
  return spec;
}

}  // namespace

void Options::add_to(CLI::App& app) {
  app.add_option("--gains", gains,
                 "stack-a, stack-b, or FILE.json with \"gains\" (default: the vehicle's)");
  app.add_option("--feed-forward", feed_forward, "none, velocity or full, whatever the gains say")
      ->check(CLI::IsMember({"none", "velocity", "full"}));
  cli::add_word(app, "--controller", controller, traj::kControlLawWords,
                "cascade (PX4's structure) or geometric (Lee 2010)");
  app.add_option("--loop-period", step,
                 "period of the position, velocity and attitude loops, s (default: 0.01 and 0.004)")
      ->check(CLI::Range(0.001, 0.1));
  app.add_option("--wind", wind, "velocity of the air, east, north, up, m/s")->type_name("E,N,U");
  app.add_option("--gusts", gusts,
                 "Dryden gusts for this wind speed at a height of 20 feet, m/s (default: 0)")
      ->check(CLI::Range(0.0, 50.0));
  app.add_option("--mass-error", mass_error,
                 "the true mass is larger than believed by this share; with --runs, by up to this "
                 "share either way")
      ->check(CLI::Range(-0.9, 10.0));
  app.add_option("--noise", noise,
                 "standard deviations of measured position, velocity, attitude and body rates: "
                 "metres, m/s, degrees, degrees/s")
      ->type_name("P,V,A,R");
  app.add_option("--delay", delay,
                 "how late the measured position and velocity are, s (default: 0)")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--hover-time", hover, "hovering before the start, s (default: 3)")
      ->check(CLI::Range(0.0, 600.0));
  app.add_option("--settle", settle, "hovering after the end, s (default: 3)")
      ->check(CLI::Range(0.0, 600.0));
  app.add_option("--log-rate", log_rate,
                 "rows a second: 100 divided by a whole number (default: 100)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--seed", seed, "seed of gusts, noise and runs (default: 0)");
  app.add_option("--runs", runs, "fly this many times more, with wind and mass by chance")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--proved-tube", proved_tube,
               "prove how far the vehicle can stray, for the winds, gusts and masses that are "
               "allowed");
  app.add_option("--wind-spread", wind_spread,
                 "with --proved-tube: the mean wind is within this of --wind, m/s (default: 0)")
      ->check(CLI::Range(0.0, 50.0));
  app.add_option("--gust-most", gust_most,
                 "with --proved-tube: what gusts run towards is at most this, m/s (default: 0)")
      ->check(CLI::Range(0.0, 50.0));
  app.add_option("--gust-lag", gust_lag,
                 "with --proved-tube: the time constant of gusts, s (default: 1)")
      ->check(CLI::Range(0.01, 1000.0));
  app.add_option("--drag-error", drag_error,
                 "with --proved-tube: the drag is within this share of the profile's (default: 0)")
      ->check(CLI::Range(0.0, 0.5));
  app.add_option("--motor-lag-error", motor_lag_error,
                 "with --proved-tube: the motors' time constant is within this share of the "
                 "profile's (default: 0)")
      ->check(CLI::Range(0.0, 0.5));
  app.add_option("--inertia-error", inertia_error,
                 "with --proved-tube: the inertia about each axis is within this share of the "
                 "profile's (default: 0)")
      ->check(CLI::Range(0.0, 0.5));
  app.add_flag("--clear-tube", tube,
               "with a map and --runs or --proved-tube: ask whether the map is clear with the "
               "tube added");
  app.add_flag("--tune", tune, "write gains found for these trajectories instead of a log");
  app.add_option("--cost", cost,
                 "what --tune makes small: mean, rms, p99, max, final, saturated, each with a "
                 "weight, as mean:1,max:0.5 (default: rms)");
  metres.add_to(app);
}

traj::FlightOptions Options::flight(const traj::VehicleProfile& profile) const {
  const auto quadrotor = traj::quadrotor_of(profile.airframe);
  if (!quadrotor) {
    throw cli::UsageError(
        "--vehicle: flight needs a FILE.json with mass_kg, inertia_kg_m2, motor_time_constant_s, "
        "thrust_n, motor_arm_m and torque_per_thrust_m (data/vehicles has some)");
  }
  traj::FlightOptions out;
  out.quadrotor = *quadrotor;
  out.gains = gains_from(gains, *profile.airframe.gains);
  if (!feed_forward.empty()) {
    const double full = feed_forward == "full";
    out.gains.feed_forward = {feed_forward == "none" ? 0.0 : 1.0, full, full};
  }
  out.law = controller;
  if (step > 0) {
    const int period = milliseconds("--loop-period", step);
    out.periods = {period, period};
  }
  out.mass_error = mass_error;
  if (!wind.empty()) {
    const auto v = numbers("--wind", wind, 3, "east,north,up in m/s within 100");
    out.wind.mean = {v[0], v[1], v[2]};
    if (out.wind.mean.cwiseAbs().maxCoeff() > 100) {
      throw cli::UsageError(
          fmt::format("--wind: expected east,north,up in m/s within 100, found \"{}\"", wind));
    }
  }
  out.wind.gusts = gusts;
  out.sensors = sensors(noise, delay);
  out.seed = seed;
  out.hover = hover;
  out.settle = settle;
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

traj::Disturbances Options::disturbances(const traj::FlightOptions& flight) const {
  const auto refuse = [](std::string_view what) {
    throw cli::UsageError(fmt::format("--proved-tube: {}", what));
  };
  const traj::SensorSpec& s = flight.sensors;
  if (std::max({s.position, s.velocity, s.attitude, s.rates, s.delay}) > 0) {
    refuse("the proof knows exact sensors: leave out --noise and --delay");
  }
  if (flight.wind.gusts > 0) {
    refuse("Dryden gusts (--gusts) have no bound: say --gust-most and --gust-lag");
  }
  if (flight.hover < traj::kStep)
    refuse("give a --hover-time of at least 0.001: the proof starts at rest");
  if (flight.periods.attitude > 4) refuse("give a --loop-period of at most 0.004");
  if (std::abs(mass_error) > 0.5) refuse("give a --mass-error of at most 0.5");
  const bool geometric = flight.law == traj::ControlLaw::geometric;
  const traj::PidGains& position = flight.gains.position;
  if ((geometric ? flight.gains.geometric.position : position.p).minCoeff() <= 0) {
    refuse("the position gains must be above 0");
  }
  if (!geometric && !(position.i.isZero(0) && position.d.isZero(0))) {
    refuse(
        "under the cascade the proof knows no i and d of the position loop, and these gains have "
        "some");
  }
  const traj::PidGains& velocity = flight.gains.velocity;
  if (!geometric &&
      !(velocity.p.minCoeff() > 0 && velocity.i.minCoeff() >= 0 && velocity.d.minCoeff() >= 0)) {
    refuse("the velocity gains must have p above 0, and i and d at least 0");
  }
  return {.wind = flight.wind.mean,
          .wind_spread = wind_spread,
          .gust_most = gust_most,
          .gust_lag = gust_lag,
          .mass_error = std::abs(mass_error),
          .drag_error = drag_error,
          .motor_lag_error = motor_lag_error,
          .inertia_error = inertia_error};
}

traj::MonteCarloOptions Options::spread() const { return {runs, std::abs(mass_error)}; }

int Options::log_period() const {
  const double samples = 100 / log_rate;
  if (std::abs(samples - std::round(samples)) > 1e-9) {
    throw cli::UsageError(
        fmt::format("--log-rate: expected 100 over a whole number, found {}", log_rate));
  }
  return static_cast<int>(std::lround(samples)) * 10;
}

}  // namespace fly
