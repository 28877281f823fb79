#pragma once

// --ground-model, --terrain-error and --surface-band: what a mission's heights above terrain, or
// above the surface that an aircraft sees, count from.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geom/map/ground_model.h"
#include "traj/mission/mavlink/mission_flight.h"
#include "traj/mission/read_mission.h"

namespace cli {

class TerrainOption {
 public:
  void add_to(CLI::App& app);

  // Throws UsageError for the ground or one of the others alone, and beside a flat ground in the
  // rules.
  void refuse_idle(const traj::MissionRules& rules) const;

  // Reads the ground, where it was given, once. Throws InputError where it is that of another map.
  // The rules point into this.
  void settle(const geom::Frame& frame, traj::MissionRules& rules);

  // The file of the ground; empty where there is none.
  std::string file() const;
  // Whether the ground was given, the metres of --terrain-error, and --surface-band.
  bool any() const { return !word_.empty(); }
  std::optional<double> error() const { return error_; }
  std::optional<traj::SurfaceBand> surface() const { return surface_; }

 private:
  std::string word_;
  std::optional<double> error_;
  std::optional<traj::SurfaceBand> surface_;
  std::optional<geom::GroundModel> ground_;
};

}  // namespace cli
