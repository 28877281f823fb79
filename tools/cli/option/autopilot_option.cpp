#include "autopilot_option.h"

#include <fmt/format.h>

#include <utility>

#include "cli/answer/exit.h"
#include "cli/file/files.h"
#include "numbers_option.h"

namespace cli {
namespace {

constexpr double kFurthest = 100;  // m
constexpr double kMostDrag = 2;    // 1/s: at 5 m/s that is the weight

void add_uncertainty(CLI::App& app, const std::string& flag,
                     std::optional<traj::Uncertainty>& value, const std::string& description) {
  app.add_option_function<std::string>(
         flag,
         [&value, flag](const std::string& text) {
           const auto v = parse_numbers(text, 2);
           if (!v || !((*v)[0] >= 0 && (*v)[0] <= kFurthest) ||
               !((*v)[1] >= 0 && (*v)[1] <= kFurthest)) {
             throw UsageError(
                 flag +
                 ": expected metres across and metres up or down, each from 0 to 100, as "
                 "0.5,1; found \"" +
                 text + '"');
           }
           value = traj::Uncertainty{(*v)[0], (*v)[1]};
         },
         description)
      ->type_name("H,V");
}

// The largest drag over mass that the profile tells.
std::optional<double> drag_of(const std::optional<traj::VehicleProfile>& profile) {
  if (!profile || !profile->airframe.drag || !profile->airframe.mass) return std::nullopt;
  return profile->airframe.drag->maxCoeff() / *profile->airframe.mass;
}

}  // namespace

void AutopilotOptions::add_reading_to(CLI::App& app) {
  app.add_option("--autopilot", word,
                 fmt::format("what flies a mission: {} (default any: what is proved holds for "
                             "each of them)",
                             traj::autopilot_words()))
      ->check([](const std::string& text) {
        if (traj::autopilots_of(text)) return std::string();
        return fmt::format("expected {}, found \"{}\"", traj::autopilot_words(), text);
      });
  app.add_option("--params", params,
                 "the autopilot's parameters: .params of PX4 or QGroundControl, .param of "
                 "ArduPilot, or a PX4 log")
      ->type_name("FILE");
}

void AutopilotOptions::add_to(CLI::App& app) {
  add_reading_to(app);
  app.add_option(
         "--drag", drag,
         fmt::format("the airframe's drag over its mass, 1/s, of which autopilots overshoot "
                     "their stops (default: the profile's, else {})",
                     traj::kUsualDrag))
      ->check(CLI::Range(0.0, kMostDrag));
  add_uncertainty(app, "--navigation", flier.navigation,
                  "metres across, and up or down, by which the vehicle may be wrong about where it "
                  "is (default: the profile's navigation_m, else 0)");
}

void AutopilotOptions::add_tracking_to(CLI::App& app) {
  add_uncertainty(app, "--tracking", flier.tracking,
                  "metres across, and up or down, by which the vehicle may stray from setpoints or "
                  "a trajectory (default 0; a mission's is part of its autopilot)");
}

void AutopilotOptions::settle(const std::optional<traj::VehicleProfile>& profile) {
  if (!flier.navigation && profile && profile->navigation) {
    flier.navigation = traj::Uncertainty{profile->navigation->x(), profile->navigation->y()};
  }
  if (!drag) drag = drag_of(profile);
  traj::AutopilotChoice choice{.word = word, .parameters_name = params, .drag = drag};
  if (!params.empty()) choice.parameters = InputFile(params).read_all();
  flier = traj::with_autopilots(std::move(flier), choice);
}

}  // namespace cli
