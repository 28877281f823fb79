#pragma once

// --grid of skyway-query: a map of free heights or of distances to obstacles, as a GeoTIFF.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/run.h"
#include "geom/collision/collision.h"

namespace querying {

class Grid {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return !what_.empty(); }
  // Throws cli::UsageError for options that mean nothing together.
  void refuse_idle(const CLI::App& app) const;

  // Each cell's number holds in all of the cell (geom/collision/height_grid.h). `output`: a
  // GeoTIFF.
  void write(const geom::CollisionScene& scene, const std::string& output,
             const geom::Execution& run) const;

 private:
  std::string what_;  // "heights" or "distance"; empty: not asked for
  double cell_ = 5;   // m
  std::optional<double> height_;
};

}  // namespace querying
