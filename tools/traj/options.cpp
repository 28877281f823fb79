#include "options.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/solver_words.h"
#include "cli/option/word_for.h"
#include "cli/run.h"

namespace solving {
namespace {

constexpr double kYawRate = std::numbers::pi / 2;  // rad/s, where none is asked for

// --yaw along, DEGREES, or X,Y of a point to look at; up to 90 degrees/s, and no more than the
// vehicle's, where no limit is given.
std::optional<traj::YawOptions> yaw_options(const std::string& text, bool rate_asked,
                                            traj::Limits& limits) {
  if (text.empty()) return std::nullopt;
  if (!rate_asked)
    limits[traj::Limit::yaw_rate] =
        std::min(limits[traj::Limit::yaw_rate].value_or(kYawRate), kYawRate);
  traj::YawOptions yaw;
  yaw.rate = *limits[traj::Limit::yaw_rate] * (1 - 1e-9);  // room for rounding in the proof
  if (text == "along") return yaw;
  if (const auto degrees = cli::parse_numbers(text, 1)) {
    yaw.kind = traj::YawOptions::Kind::fixed;
    yaw.angle = degrees->front() * std::numbers::pi / 180;
  } else if (const auto point = cli::parse_numbers(text, 2)) {
    yaw.kind = traj::YawOptions::Kind::towards;
    yaw.target = {point->front(), point->back(), 0};
  } else {
    throw cli::UsageError(
        fmt::format("--yaw: expected along, degrees, or X,Y of a point, found {}", text));
  }
  return yaw;
}

}  // namespace

void Options::add_to(CLI::App& app) {
  limits.add_to(app);
  metres.add_to(app);
  app.add_option("--solver", solver, "auto, closed, banded, ipopt or stop-and-go")
      ->check(CLI::IsMember({"auto", "closed", "banded", "ipopt", "stop-and-go"}));
  app.add_option("--times", times, "leg times: stops, distance, cautious, trapezoid or optimised")
      ->check(CLI::IsMember({"stops", "distance", "cautious", "trapezoid", "optimised"}));
  cli::add_word(app, "--corridor", solve.corridor, traj::kCorridorWords,
                "the optimiser stays behind planes at the obstacles (default), or in empty boxes");
  cli::add_output(app, "--corridor-file", corridor_file,
                  "write the optimiser's corridors, JSON Lines with vertices and faces to draw");
  app.add_option("--rho", solve.rho,
                 "how many seconds of flight a unit of snap (m2/s7) is worth: higher flies "
                 "smoother and slower")
      ->check(CLI::Range(0.0, 1e3));
  app.add_option("--yaw", yaw,
                 "along (the velocity), degrees from the map's x axis towards y, or X,Y of a point "
                 "to look at (default: no yaw)");
  app.add_flag("--proved-tube", proved_tube,
               "prove how far the simulated vehicle can stray, and solve until the map is clear "
               "with that tube in place of a guessed margin (--controller geometric)");
  cli::add_output(app, "--report-file", report_file,
                  "reports of the proved tubes, JSON Lines, as skyway-fly writes them");
  flown.add_to(app);
}

void Options::require_sound(const CLI::App& app) const {
  cli::SimulatedVehicleOptions::refuse_idle(app, proved_tube, "--proved-tube");
  cli::only_for(app, proved_tube, {"--report-file"}, "--proved-tube");
  if (proved_tube && report_file.empty()) {
    throw cli::UsageError("--proved-tube: give --report-file, which gets the tubes");
  }
}

void Options::choose_solver() { cli::choose_solver(solver, times, solve); }

geom::Limits Options::limits_for(const geom::Vehicle& vehicle) const {
  const geom::Limits asked = limits.limits();
  geom::Limits held = geom::limits_that_hold({asked, {}, vehicle.limits});
  yaw_options(yaw, asked[traj::Limit::yaw_rate].has_value(), held);
  return held;
}

Task Options::task(const geom::Vehicle& vehicle) const {
  const geom::Limits asked = limits.limits();
  Task task{solve, std::nullopt};
  task.options.limits = geom::limits_to_solve(asked, vehicle);
  task.yaw = yaw_options(yaw, asked[traj::Limit::yaw_rate].has_value(), task.options.limits);
  return task;
}

}  // namespace solving
