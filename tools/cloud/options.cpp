#include "options.h"

#include <cmath>

#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/run.h"
#include "geom/cloud/las_class.h"

namespace cloud {
namespace {

std::vector<cli::FormatOption> format_options() {
  std::vector<std::string_view> surveyed;
  for (const geom::CloudFormat* format : geom::cloud_formats()) {
    if (format->is_surveyed) surveyed.push_back(format->format->word);
  }
  return {{"--classes", surveyed},
          {"--noise-points", surveyed},
          {"--resolution", surveyed},
          {"--ground-by", surveyed}};
}

// A class by number or name, or a group of classes.
void add_class(const std::string& word, std::bitset<256>& classes) {
  const std::bitset<256> named = geom::las_class_set(word);
  if (named.none()) {
    throw cli::UsageError("--classes: expected numbers from 0 to 255 or names (" +
                          std::string(geom::las_class_names()) + "), found \"" + word + '"');
  }
  classes |= named;
}

void add_ground(CLI::App& app, Options& options) {
  app.add_option("--ground-points", options.ground,
                 "keep (default) the ground as boxes, or drop it")
      ->check(CLI::IsMember({"keep", "drop"}));
  app.add_option("--ground-by", options.draft.ground_by,
                 "what tells the ground: the file's class, its shape, or (auto, the default) the "
                 "class where a point has it, else the shape")
      ->check(CLI::IsMember({"auto", "class", "shape"}));
  app.add_option("--ground-cell", options.draft.ground.cell,
                 "cells whose lowest returns make the ground, metres (default 2)")
      ->check(CLI::Range(0.1, 1000.0));
  app.add_option("--ground-slope", options.draft.ground.slope,
                 "metres that ground may rise in a metre (default 0.1)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--ground-height", options.draft.ground.height,
                 "metres above the ground that still count as ground (default 0.3)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--ground-step", options.draft.ground.step,
                 "metres, on top of the slope, from one cell of the ground to the next (default "
                 "1): what is behind a higher step is no ground")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option(
         "--ground-widest", options.draft.ground.widest,
         "metres: ground is grown from the lowest places this far around, and from surfaces "
         "wider than this (default 200)")
      ->check(CLI::Range(1.0, 1e6));
}

void add_objects(CLI::App& app, Options& options) {
  app.add_option("--tolerance", options.draft.tolerance,
                 "points this near to each other, metres, are one object (default 1)")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--min-points", options.draft.min_points,
                 "drop objects of fewer points (default 1)")
      ->check(CLI::Range(1, 1000000));
}

void add_columns(CLI::App& app, Options& options) {
  app.add_option("--cell", options.draft.columns.cell, "side of a column, metres (default 1)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option(
         "--step", options.draft.columns.step,
         "heights of columns are rounded outward to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.05, 1000.0));
  app.add_option("--gap", options.draft.columns.gap,
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
           for (const std::string& word : words) add_class(word, draft.classes);
         },
         "keep only these LAS classes, by name or number: ground,building,9,…")
      ->delimiter(',')
      ->type_name("CLASS,…");
  app.add_option("--noise-points", noise,
                 "keep (default) what the file classifies as noise as boxes, or drop it")
      ->check(CLI::IsMember({"keep", "drop"}));
  app.add_option("--outliers", outliers,
                 "NEIGHBOURS,DEVIATIONS: drop points far from their neighbours");
  app.add_option("--voxel", draft.voxel, "keep one point per cube of this side, metres")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--resolution", draft.resolution,
                 "of a COPC file: read points only until they are this near to each other, metres; "
                 "needs --allow-skipped, and grows boxes by that distance")
      ->check(CLI::Range(0.001, 1000.0));
  add_ground(app, *this);
  add_objects(app, *this);
  app.add_option("--unknown", unknown, "space that was not scanned: free (default) or blocked")
      ->check(CLI::IsMember({"free", "blocked"}));
  place.add_to(app);
  cli::add_allow_skipped(app, draft.allow_skipped);
  cli::add_map_options(app, draft.map);
}

void Options::settle() {
  draft.place = place.options();
  draft.columns.unknown_blocked = unknown == "blocked";
  draft.drop_noise = noise == "drop";
  draft.drop_ground = ground == "drop";
  draft.objects = mode == "objects";
  draft.ground_told = [this](const std::string& by) { require_used_ground(by); };
  settle_outliers();
  cli::only_for(*app_, mode == "columns", {"--cell", "--step", "--gap", "--unknown"},
                "--mode columns");
  cli::only_for(*app_, mode == "objects", {"--tolerance", "--min-points"}, "--mode objects");
  cli::only_for(*app_, draft.drop_ground, {"--ground-by"}, "--ground-points drop");
  if (!draft.drop_ground || draft.ground_by == "class") require_used_ground("");
}

void Options::settle_format(const geom::CloudFormat& known, const std::string& name) {
  draft.format = format = &known;
  const std::string_view word = known.format->word;
  cli::require_used(*app_, format_options(), word, cli::read_as(name, word));
}

void Options::require_used_ground(const std::string& told_by) const {
  cli::only_for(
      *app_, told_by == "shape",
      {"--ground-cell", "--ground-slope", "--ground-height", "--ground-step", "--ground-widest"},
      "--ground-points drop by shape (--ground-by shape; auto takes the file's class where a point "
      "has that of ground)");
}

void Options::settle_outliers() {
  if (outliers.empty()) return;
  const auto numbers = cli::parse_numbers(outliers, 2);
  const double k = numbers ? (*numbers)[0] : 0;
  if (!(k >= 1 && k <= 1000) || k != std::floor(k) || !((*numbers)[1] > 0)) {
    throw cli::UsageError("--outliers must be NEIGHBOURS,DEVIATIONS, found \"" + outliers + "\"");
  }
  draft.outliers = {static_cast<int>(k), (*numbers)[1]};
}

}  // namespace cloud
