#pragma once

// --ground-model and --terrain-error: what a mission's heights above terrain count from.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geom/map/ground_model.h"
#include "traj/mission/mavlink/mission_flight.h"

namespace cli {

class TerrainOption {
 public:
  void add_to(CLI::App& app);

  // Throws UsageError for one without the other, and beside a flat ground in the rules.
  void refuse_idle(const traj::MissionRules& rules) const;

  // Reads the ground, where it was given, once. Throws InputError where it is that of another map.
  // The rules point into this.
  void settle(const geom::Frame& frame, traj::MissionRules& rules);

  // The file of the ground; empty where there is none.
  std::string file() const;
  // Whether the ground was given, and the metres of --terrain-error.
  bool any() const { return !word_.empty(); }
  double error() const { return error_.value_or(0); }

 private:
  std::string word_;
  std::optional<double> error_;
  std::optional<geom::GroundModel> ground_;
};

}  // namespace cli
