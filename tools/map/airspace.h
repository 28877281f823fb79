#pragma once

// Options of `skyway-map patch` for zones of airspace and limits over the ground.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/run.h"
#include "geom/map/map_patch.h"

namespace verbs {

struct Airspace {
  std::string zones;    // a file
  std::string types;    // empty: all that restrict
  std::string ground;   // a file, or one height
  std::string ceiling;  // "120agl"
  std::string agl;      // "LOW,HIGH"
  std::optional<double> zero_sea;
  std::optional<double> geoid;
  std::string geoid_grid;  // a name or a file
  double step = 2;
  int days = 7;
  bool close_unknown = false;

  void add_to(CLI::App& app);
  bool any() const { return !zones.empty() || !ceiling.empty() || !agl.empty(); }
  void refuse_idle(const CLI::App& app) const;  // throws cli::UsageError
};

// What else of the patch counts for zones.
struct AirspaceHeights {
  const geom::BoxMap& map;            // before the patch
  std::optional<double> zero_height;  // of z = 0 above the ellipsoid, metres
  double slack = 0.5;
};

// Adds the boxes and says in the history what they come from; says on stderr which zones there are,
// and counts boxes in `stats`.
void patch_airspace(const Airspace& airspace, const AirspaceHeights& heights, geom::MapPatch& patch,
                    const cli::Common& common, nlohmann::ordered_json& stats);

}  // namespace verbs
