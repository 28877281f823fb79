#include "terrain_option.h"

#include "cli/option/ground_option.h"
#include "cli/option/numbers_option.h"
#include "geom/base/usage_error.h"

namespace cli {

void TerrainOption::add_to(CLI::App& app) {
  app.add_option("--ground-model", word_,
                 "the ground below a mission with heights above terrain, which is then a band of "
                 "heights: a file of skyway-footprints --ground-of, or the map's z of flat ground");
  app.add_option("--terrain-error", error_,
                 "metres that the autopilot's own terrain may be above or below the ground at its "
                 "posts")
      ->check(CLI::Range(0.0, 1000.0));
}

void TerrainOption::refuse_idle(const traj::MissionRules& rules) const {
  if (word_.empty() && !error_) return;
  if (word_.empty()) {
    throw geom::UsageError("--terrain-error counts from the ground: give --ground-model");
  }
  if (!error_) {
    throw geom::UsageError(
        "--ground-model: an autopilot follows terrain of its own, so say how far that may be off: "
        "--terrain-error METRES (of SRTM, 16 m is what its specification allows for)");
  }
  if (rules.ground) {
    throw geom::UsageError(
        "--terrain-height says that the ground is flat: leave it or "
        "--ground-model out");
  }
}

void TerrainOption::settle(const geom::Frame& frame, traj::MissionRules& rules) {
  if (word_.empty()) return;
  if (!ground_) ground_ = ground_from(word_);
  geom::require_same_frame(*ground_, frame, word_);
  rules.terrain = traj::TerrainRules{&*ground_, frame.axes, *error_};
}

std::string TerrainOption::file() const {
  return word_.empty() || parse_numbers(word_, 1) ? std::string() : word_;
}

}  // namespace cli
