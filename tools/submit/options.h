#pragma once

// What the user asked of skyway-submit.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/content/terrain_option.h"
#include "cli/option/autopilot_option.h"
#include "cli/option/limit_options.h"
#include "cli/option/vehicle_option.h"
#include "traj/mission/formats/placement.h"
#include "traj/submit/operation.h"
#include "traj/submit/submission.h"

namespace submitting {

struct Options {
  std::string map;
  std::vector<std::string> flights;
  std::string folder;
  std::string operation;
  std::string population;                                          // empty: not asked for
  std::string tube;                                                // likewise
  const std::string& params() const { return autopilot_.params; }  // empty: none
  const std::shared_ptr<const geom::GeoidGrid>& geoid_grid() const { return placement_.geoid_grid; }
  bool no_page = false;
  bool says_floor() const { return floor_.has_value(); }
  cli::VehicleOptions vehicle;
  cli::LimitOptions limits;
  cli::TerrainOption terrain;

  // Must outlive the app.
  void add_to(CLI::App& app);
  // Throws cli::UsageError for options that do not go together.
  void require_sound(const CLI::App& app) const;

  // The method that the options and the operation name, over a map.
  traj::SubmissionMethod method(const traj::Operation& by, const geom::BoxMapSpec& map,
                                const std::string& hash) const;

 private:
  void add_risk(CLI::App& app);
  void take_between(const std::string& text);

  traj::SubmissionMethod asked_;
  std::string contingency_ = "stop";
  std::string ground_buffer_ = "1:1";
  std::optional<double> tilt_deg_;
  std::optional<double> floor_;
  std::string between_;
  traj::Placement placement_;
  cli::AutopilotOptions autopilot_;
  bool together_ = false;
  traj::TogetherRule rule_;
};

}  // namespace submitting
