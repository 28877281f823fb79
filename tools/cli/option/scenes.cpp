#include "scenes.h"

namespace cli {

Scenes::Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences)
    : Scenes(std::move(map), options, differences, options.profile()) {}

Scenes::Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences,
               const std::optional<traj::VehicleProfile>& profile)
    : geom::Scenes(std::move(map), options.asked(profile), differences, options.budget()),
      profile_(profile) {}

nlohmann::ordered_json Scenes::stats() const {
  const geom::CollisionCounts last = counts();
  return {{"groups", last.groups},
          {"built", last.built},
          {"built_again", last.built_again},
          {"most_bytes", last.most_bytes},
          {"memory", budget()}};
}

}  // namespace cli
