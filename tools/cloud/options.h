#pragma once

// What skyway-cloud is asked, beside its files and shards.

#include <CLI/CLI.hpp>
#include <bitset>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/option/map_output.h"
#include "cli/option/skipped_option.h"
#include "geom/cloud/cloud_format.h"
#include "geom/map/column_grid.h"
#include "geom/map/ground_grid.h"
#include "place_options.h"

namespace cloud {

struct Options {
  const geom::CloudFormat* format = nullptr;  // null: found out
  std::string mode = "columns";
  std::string ground = "keep";
  std::string ground_by = "auto";
  std::string noise = "keep";
  std::string unknown = "free";
  std::string outliers;  // "NEIGHBOURS,DEVIATIONS"
  double voxel = 0;
  double resolution = 0;  // metres; 0: all points
  double tolerance = 1;
  std::size_t min_points = 1;
  std::bitset<256> classes;  // none: all
  geom::ColumnSpec columns;
  geom::GroundSpec ground_spec;
  PlaceOptions place;
  geom::CloudPlace placement;  // once settled
  cli::SkippedOption skipped;
  cli::MapOptions map;

  void add_to(CLI::App& app);
  void settle();  // once parsed; throws cli::UsageError

  // Once it is known what the file is, and what told its ground ("shape", "class"): throws
  // cli::UsageError for options that change nothing then.
  void settle_format(const geom::CloudFormat& known, const std::string& name);
  void require_used_ground(const std::string& told_by) const;

  // Whether what lies outside the bounds, or is finer than the resolution, changes nothing of how
  // the rest is made into boxes: then it need not be read.
  bool each_point_alone() const;

  bool drops_ground() const { return ground == "drop"; }
  // The steps that look at all points together.
  bool in_memory() const { return !outliers.empty() || voxel > 0 || mode == "objects"; }

 private:
  const CLI::App* app_ = nullptr;
};

// The step of the map's history; `input` says which it was, `ground_by` how ground was told.
nlohmann::ordered_json step_of(const Options& options, const nlohmann::ordered_json& input,
                               const std::string& ground_by, const geom::MakeMapOptions& map);

}  // namespace cloud
