#include "simulated_vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/answer/exit.h"
#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/word_for.h"
#include "geom/text/json_fields.h"
#include "traj/flight/gains_record.h"

namespace cli {
namespace {

traj::Gains gains_from(const std::string& word, const traj::Gains& own) {
  if (word.empty()) return own;
  if (const auto preset = traj::preset_gains(word, own)) return *preset;
  if (!word.ends_with(".json")) {
    throw UsageError(
        fmt::format("--gains: expected stack-a, stack-b or FILE.json, found \"{}\"", word));
  }
  InputFile file(word);
  const geom::JsonFields fields(file.read_all(), word, 0);
  if (!fields.has("gains")) fields.refuse({.expected = "the key \"gains\"", .found = "none"});
  return traj::parse_gains(fields, own);
}

// East, north, up, m/s.
geom::Vec3 wind_from(const std::string& text) {
  const auto v = parse_numbers(text, 3);
  if (v && std::abs((*v)[0]) <= 100 && std::abs((*v)[1]) <= 100 && std::abs((*v)[2]) <= 100) {
    return {(*v)[0], (*v)[1], (*v)[2]};
  }
  throw UsageError(
      fmt::format("--wind: expected east,north,up in m/s within 100, found \"{}\"", text));
}

using Simulated = SimulatedVehicleOptions;

// What a proof allows for beside the flight that is simulated.
constexpr struct {
  const char* flag;
  double Simulated::*value;
  double least;
  double most;
  const char* what;
} kAllowances[] = {
    {"--wind-spread", &Simulated::wind_spread, 0.0, 50.0,
     "the mean wind is within this of --wind, m/s (default: 0)"},
    {"--gust-most", &Simulated::gust_most, 0.0, 50.0,
     "what gusts run towards is at most this, m/s (default: 0)"},
    {"--gust-lag", &Simulated::gust_lag, 0.01, 1000.0,
     "the time constant of gusts, s (default: 1)"},
    {"--start-error", &Simulated::start_error, 0.0, 100.0,
     "when it begins to hover, the vehicle is within this of the first point, m (default: 0)"},
    {"--start-speed", &Simulated::start_speed, 0.0, 50.0,
     "when it begins to hover, the vehicle is at most this fast, m/s (default: 0)"},
    {"--drag-error", &Simulated::drag_error, 0.0, 0.5,
     "the drag is within this share of the profile's (default: 0)"},
    {"--motor-lag-error", &Simulated::motor_lag_error, 0.0, 0.5,
     "the motors' time constant is within this share of the profile's (default: 0)"},
    {"--inertia-error", &Simulated::inertia_error, 0.0, 0.5,
     "the inertia about each axis is within this share of the profile's (default: 0)"},
    {"--gain-error", &Simulated::gain_error, 0.0, 0.5,
     "each gain is within this share of what it should be (default: 0)"},
};

void refuse_idle_allowances(const CLI::App& app, bool apply, std::string_view to_what) {
  for (const auto& one : kAllowances) only_for(app, apply, {one.flag}, to_what);
  only_for(app, apply, {"--noise-most"}, to_what);
}

}  // namespace

traj::SensorSpec sensors_from(const char* flag, const std::string& text) {
  traj::SensorSpec spec;
  if (text.empty()) return spec;
  const auto v = parse_numbers(text, 4);
  if (!v || *std::min_element(v->begin(), v->end()) < 0) {
    throw UsageError(
        fmt::format("{}: expected four numbers >= 0: metres, m/s, degrees, degrees/s; found \"{}\"",
                    flag, text));
  }
  constexpr double radian = std::numbers::pi / 180;
  spec.position = (*v)[0];
  spec.velocity = (*v)[1];
  spec.attitude = (*v)[2] * radian;
  spec.rates = (*v)[3] * radian;
  return spec;
}

int whole_milliseconds(const char* flag, double seconds) {
  const double count = seconds * 1e3;
  if (std::abs(count - std::round(count)) > 1e-6) {
    throw UsageError(
        fmt::format("{}: expected a whole number of milliseconds, found {} s", flag, seconds));
  }
  return static_cast<int>(std::lround(count));
}

void SimulatedVehicleOptions::add_to(CLI::App& app) {
  app.add_option("--gains", gains,
                 "stack-a, stack-b, or FILE.json with \"gains\" (default: the vehicle's)");
  app.add_option("--feed-forward", feed_forward, "none, velocity or full, whatever the gains say")
      ->check(CLI::IsMember({"none", "velocity", "full"}));
  add_word(app, "--controller", controller, traj::kControlLawWords,
           "cascade (PX4's structure) or geometric (Lee 2010)");
  app.add_option("--loop-period", step,
                 "period of the position, velocity and attitude loops, s (default: 0.01 and 0.004)")
      ->check(CLI::Range(0.001, 0.1));
  app.add_option("--wind", wind, "velocity of the air, east, north, up, m/s")->type_name("E,N,U");
  app.add_option(
         "--mass-error", mass_error,
         "the true mass is larger than believed by this share; of runs and proved tubes, by "
         "up to this share either way")
      ->check(CLI::Range(-0.9, 10.0));
  app.add_option("--hover-time", hover, "hovering before the start, s (default: 3)")
      ->check(CLI::Range(0.0, 600.0));
  app.add_option("--settle", settle, "hovering after the end, s (default: 3)")
      ->check(CLI::Range(0.0, 600.0));
  for (const auto& one : kAllowances) {
    app.add_option(one.flag, this->*one.value, std::string("with --proved-tube: ") + one.what)
        ->check(CLI::Range(one.least, one.most));
  }
  app.add_option("--noise-most", noise_most,
                 "with --proved-tube: each reading of position, velocity, attitude and body rates "
                 "is off by at most this along each axis: metres, m/s, degrees, degrees/s")
      ->type_name("P,V,A,R");
}

void SimulatedVehicleOptions::refuse_idle(const CLI::App& app, bool flies,
                                          std::string_view to_what) {
  only_for(app, flies,
           {"--gains", "--feed-forward", "--controller", "--loop-period", "--wind", "--mass-error",
            "--hover-time", "--settle"},
           to_what);
  refuse_idle_allowances(app, flies, to_what);
}

void SimulatedVehicleOptions::refuse_idle_disturbances(const CLI::App& app, bool proves) {
  refuse_idle_allowances(app, proves, "--proved-tube");
}

traj::FlightOptions SimulatedVehicleOptions::flight(const traj::VehicleProfile& profile) const {
  const auto quadrotor = traj::quadrotor_of(profile.airframe);
  if (!quadrotor) {
    throw UsageError(
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
    const int period = whole_milliseconds("--loop-period", step);
    out.periods = {period, period};
  }
  out.mass_error = mass_error;
  if (!wind.empty()) out.wind.mean = wind_from(wind);
  out.hover = hover;
  out.settle = settle;
  return out;
}

traj::Disturbances SimulatedVehicleOptions::disturbances(const traj::FlightOptions& flight) const {
  const auto refuse = [](std::string_view what) {
    throw UsageError(fmt::format("--proved-tube: {}", what));
  };
  const traj::SensorSpec& s = flight.sensors;
  if (std::max({s.position, s.velocity, s.attitude, s.rates}) > 0) {
    refuse("noise by chance (--noise) has no bound: say --noise-most instead");
  }
  if (s.delay > 0) refuse("no tube is proved for late readings: leave out --delay");
  if (flight.wind.gusts > 0) {
    refuse("Dryden gusts (--gusts) have no bound: say --gust-most and --gust-lag");
  }
  if (flight.hover < traj::kStep)
    refuse("give a --hover-time of at least 0.001: the proof begins while the vehicle hovers");
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
  const traj::SensorSpec noise = sensors_from("--noise-most", noise_most);
  if (noise.attitude > 1) refuse("give an attitude in --noise-most of at most 57 degrees");
  return {.wind = flight.wind.mean,
          .wind_spread = wind_spread,
          .gust_most = gust_most,
          .gust_lag = gust_lag,
          .start_error = start_error,
          .start_speed = start_speed,
          .mass_error = std::abs(mass_error),
          .drag_error = drag_error,
          .motor_lag_error = motor_lag_error,
          .inertia_error = inertia_error,
          .gain_error = gain_error,
          .place_noise = noise.position,
          .velocity_noise = noise.velocity,
          .attitude_noise = noise.attitude,
          .rate_noise = noise.rates};
}

}  // namespace cli
