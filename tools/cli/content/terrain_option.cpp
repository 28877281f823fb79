#include "terrain_option.h"

#include <fmt/format.h>


#include "cli/option/ground_option.h"
#include "cli/option/numbers_option.h"
#include "geom/base/usage_error.h"

namespace cli {
namespace {

traj::SurfaceBand surface_band_of(const std::string& text) {
  const auto numbers = parse_numbers(text, 2);
  const traj::SurfaceBand band =
      numbers ? traj::SurfaceBand{(*numbers)[0], (*numbers)[1]} : traj::SurfaceBand{};
  if (band.sound()) return band;
  throw geom::UsageError(
      fmt::format("--surface-band: expected LOW,HIGH, 0 < LOW <= HIGH <= {:g}, found \"{}\"",
                  traj::SurfaceBand::kMost, text));
}

}  // namespace

void TerrainOption::add_to(CLI::App& app) {
  app.add_option("--ground-model", word_,
                 "the ground below a mission with heights above terrain or the surface (bands of "
                 "heights then): a file of skyway-footprints --ground-of, or flat ground's z");
  app.add_option("--terrain-error", error_,
                 "metres by which the autopilot's own terrain may be off the ground at its posts")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option_function<std::string>(
         "--surface-band", [this](const std::string& text) { surface_ = surface_band_of(text); },
         "LOW,HIGH: metres above that ground between which an aircraft of DJI stays where it "
         "follows the surface as its sensors see it (realTimeFollowSurface)")
      ->type_name("LOW,HIGH");
}

void TerrainOption::refuse_idle(const traj::MissionRules& rules) const {
  const bool tells = error_ || surface_;
  if (word_.empty() && !tells) return;
  if (word_.empty()) {
    throw geom::UsageError(fmt::format("{} counts from the ground: give --ground-model",
                                       error_ ? "--terrain-error" : "--surface-band"));
  }
  if (!tells) {
    throw geom::UsageError(
        "--ground-model: an autopilot follows terrain of its own, so say how far that may be off: "
        "--terrain-error METRES (of SRTM, 16 m is what its specification allows for); or between "
        "which heights an aircraft of DJI stays that follows the surface: --surface-band LOW,HIGH");
  }
  if (rules.ground) {
    throw geom::UsageError(
        "--terrain-height says that the ground is flat: leave it or --ground-model out");
  }
}

void TerrainOption::settle(const geom::Frame& frame, traj::MissionRules& rules) {
  if (word_.empty()) return;
  if (!ground_) ground_ = ground_from(word_);
  geom::require_same_frame(*ground_, frame, word_);
  rules.terrain = traj::TerrainRules{&*ground_, frame.axes, error_, surface_};
}

std::string TerrainOption::file() const {
  return word_.empty() || parse_numbers(word_, 1) ? std::string() : word_;
}

}  // namespace cli
