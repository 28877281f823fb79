#pragma once

// The scenes of a map for what records and the options --vehicle and --margin ask.

#include <nlohmann/json.hpp>
#include <optional>

#include "geom/record/scenes.h"
#include "vehicle_option.h"

namespace cli {

class Scenes : public geom::Scenes {
 public:
  using Differences = geom::Differences;

  Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences);

  // For --stats: how many groups of tiles the last scene built, and built again.
  nlohmann::ordered_json stats() const;
  const std::optional<traj::VehicleProfile>& profile() const { return profile_; }

 private:
  Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences,
         const std::optional<traj::VehicleProfile>& profile);

  std::optional<traj::VehicleProfile> profile_;
};

}  // namespace cli
