#include "layers.h"

namespace view {

Clearance::Clearance(const cli::Contents& contents, const cli::VehicleOptions& vehicle) {
  if (const auto profile = vehicle.profile()) asked_ = profile->vehicle;
  if (contents.map) {
    scenes_.emplace(contents.map->record, vehicle, cli::Scenes::Differences::refused);
  }
}

std::optional<geom::Vehicle> Clearance::vehicle(const geom::Provenance& made_for) const {
  return asked_ ? asked_ : made_for.vehicle;
}

const geom::CollisionScene* Clearance::scene_for(const geom::Provenance& made_for,
                                                 const std::string& source, std::size_t line) {
  if (!scenes_ || !vehicle(made_for)) return nullptr;
  return &scenes_->scene_for(made_for, source, line);
}

}  // namespace view
