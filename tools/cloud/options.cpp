#include "options.h"

#include "cli/option/format_options.h"
#include "cli/option/option_check.h"
#include "cli/run.h"
#include "geom/cloud/las_class.h"
#include "geom/text/text_table.h"

namespace cloud {
namespace {

std::vector<cli::FormatOption> format_options() {
  std::vector<std::string_view> surveyed;
  for (const geom::CloudFormat* format : geom::cloud_formats()) {
    if (format->is_surveyed) surveyed.push_back(format->format->word);
  }
  return {{"--classes", surveyed},
          {"--noise", surveyed},
          {"--resolution", surveyed},
          {"--ground-by", surveyed}};
}

// A class by number or name, or a group of classes.
void add_class(const std::string& word, std::bitset<256>& classes) {
  const auto named = geom::las_classes(word);
  for (const std::uint8_t cls : named) classes.set(cls);
  if (!named.empty()) return;
  const auto number = geom::parse_number(word);
  if (!number || !(*number >= 0 && *number <= 255) || *number != static_cast<int>(*number)) {
    throw cli::UsageError("--classes: expected numbers from 0 to 255 or names (" +
                          std::string(geom::las_class_names()) + "), found \"" + word + '"');
  }
  classes.set(static_cast<std::size_t>(*number));
}

void add_ground(CLI::App& app, Options& options) {
  app.add_option("--ground", options.ground, "keep (default) the ground as boxes, or drop it")
      ->check(CLI::IsMember({"keep", "drop"}));
  app.add_option("--ground-by", options.ground_by,
                 "what tells the ground: the file's class, its shape, or (auto, the default) the "
                 "class where a point has it, else the shape")
      ->check(CLI::IsMember({"auto", "class", "shape"}));
  app.add_option("--ground-cell", options.ground_spec.cell,
                 "cells whose lowest returns make the ground, metres (default 2)")
      ->check(CLI::Range(0.1, 1000.0));
  app.add_option("--ground-slope", options.ground_spec.slope,
                 "metres that ground may rise in a metre (default 0.1)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--ground-height", options.ground_spec.height,
                 "metres above the ground that still count as ground (default 0.3)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--ground-step", options.ground_spec.step,
                 "metres, on top of the slope, from one cell of the ground to the next (default "
                 "1): what is behind a higher step is no ground")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option(
         "--ground-widest", options.ground_spec.widest,
         "metres: ground is grown from the lowest places this far around, and from surfaces "
         "wider than this (default 200)")
      ->check(CLI::Range(1.0, 1e6));
}

void add_objects(CLI::App& app, Options& options) {
  app.add_option("--tolerance", options.tolerance,
                 "points this near to each other, metres, are one object (default 1)")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--min-points", options.min_points, "drop objects of fewer points (default 1)")
      ->check(CLI::Range(1, 1000000));
}

void add_columns(CLI::App& app, Options& options) {
  app.add_option("--cell", options.columns.cell, "side of a column, metres (default 1)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option(
         "--step", options.columns.step,
         "heights of columns are rounded outward to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option("--gap", options.columns.gap,
                 "returns of a column that are further apart than this, metres, have free space "
                 "between them (default 2)")
      ->check(CLI::Range(0.0, 1e6));
}

}  // namespace

void Options::add_to(CLI::App& app) {
  app_ = &app;
  cli::add_format(app, geom::cloud_formats(), format);
  app.add_option("--mode", mode, "boxes per column (default) or per object")
      ->check(CLI::IsMember({"columns", "objects"}));
  add_columns(app, *this);
  app.add_option_function<std::vector<std::string>>(
         "--classes",
         [this](const std::vector<std::string>& words) {
           for (const std::string& word : words) add_class(word, classes);
         },
         "keep only these LAS classes, by name or number: ground,building,9,…")
      ->delimiter(',')
      ->type_name("CLASS,…");
  app.add_option("--noise", noise,
                 "keep (default) what the file classifies as noise as boxes, or drop it")
      ->check(CLI::IsMember({"keep", "drop"}));
  app.add_option("--outliers", outliers,
                 "NEIGHBOURS,DEVIATIONS: drop points far from their neighbours");
  app.add_option("--voxel", voxel, "keep one point per cube of this side, metres")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--resolution", resolution,
                 "of a COPC file: read points only until they are this near to each other, metres; "
                 "needs --allow-skipped, and grows boxes by that distance")
      ->check(CLI::Range(0.001, 1000.0));
  add_ground(app, *this);
  add_objects(app, *this);
  app.add_option("--unknown", unknown, "space that was not scanned: free (default) or blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  place.add_to(app);
  skipped.add_to(app);
  map.add_to(app);
}

void Options::settle() {
  placement = geom::CloudPlace(place.options());
  columns.unknown_blocked = unknown == "blocked";
  cli::only_for(*app_, mode == "columns", {"--cell", "--step", "--gap", "--unknown"},
                "--mode columns");
  cli::only_for(*app_, mode == "objects", {"--tolerance", "--min-points"}, "--mode objects");
  cli::only_for(*app_, drops_ground(), {"--ground-by"}, "--ground drop");
  if (!drops_ground() || ground_by == "class") require_used_ground("");
  if (resolution > 0 && !each_point_alone()) {
    throw cli::UsageError(
        "--resolution leaves points out, so it does not go with what looks at all of them: "
        "--outliers, --voxel, --mode objects, --unknown blocked, --scale, --bloat-percent, and "
        "--ground drop unless by class");
  }
}

void Options::settle_format(const geom::CloudFormat& known, const std::string& name) {
  format = &known;
  const std::string_view word = known.format->word;
  cli::require_used(*app_, format_options(), word, cli::read_as(name, word));
}

void Options::require_used_ground(const std::string& told_by) const {
  cli::only_for(
      *app_, told_by == "shape",
      {"--ground-cell", "--ground-slope", "--ground-height", "--ground-step", "--ground-widest"},
      "--ground drop by shape (--ground-by shape; auto takes the file's class where a point has "
      "that of ground)");
}

bool Options::each_point_alone() const {
  const bool whole_ground = drops_ground() && ground_by != "class";
  return !in_memory() && !whole_ground && !columns.unknown_blocked && map.map.scale == 1 &&
         map.map.bloat_percent == 0;
}

nlohmann::ordered_json step_of(const Options& options, const nlohmann::ordered_json& input,
                               const std::string& ground_by, const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {{"tool", "skyway-cloud"}};
  step.update(input);
  step.update({{"format", options.format->format->word},
               {"mode", options.mode},
               {"cell", options.columns.cell},
               {"step", options.columns.step},
               {"gap", options.columns.gap},
               {"ground", options.ground},
               {"unknown", options.unknown}});
  if (options.resolution > 0) step["resolution"] = options.resolution;
  if (!options.outliers.empty()) step["outliers"] = options.outliers;
  if (options.voxel > 0) step["voxel"] = options.voxel;
  for (std::size_t cls = 0; cls < options.classes.size(); ++cls) {
    if (options.classes[cls]) step["classes"].push_back(cls);
  }
  if (options.noise == "drop") step["noise"] = options.noise;
  if (options.drops_ground()) step["ground_by"] = ground_by;
  if (options.drops_ground() && ground_by == "shape") {
    step["ground_cell"] = options.ground_spec.cell;
    step["ground_slope"] = options.ground_spec.slope;
    step["ground_height"] = options.ground_spec.height;
    step["ground_step"] = options.ground_spec.step;
    step["ground_widest"] = options.ground_spec.widest;
  }
  if (options.mode == "objects") {
    step["tolerance"] = options.tolerance;
    step["min_points"] = options.min_points;
  }
  options.place.record(options.placement, step);
  step.update(cli::history_of(map));
  return step;
}

}  // namespace cloud
