#include <limits>

#include "view/layers.h"

namespace view {

Clearance::Clearance(const Contents& contents, const cli::VehicleOptions& vehicle) {
  if (const auto profile = vehicle.profile()) asked_ = profile->vehicle;
  if (contents.map) {
    scenes_.emplace(contents.map->record, vehicle, cli::Scenes::Differences::refused);
  }
}

std::optional<geom::Vehicle> Clearance::vehicle(const geom::Provenance& made_for) const {
  return asked_ ? asked_ : made_for.vehicle;
}

std::vector<float> Clearance::at(const std::vector<geom::Vec3>& points,
                                 const geom::Provenance& made_for, const std::string& source,
                                 std::size_t line) {
  if (!scenes_ || scenes_->map().size() == 0 || !vehicle(made_for)) return {};
  const geom::CollisionScene& scene = scenes_->scene_for(made_for, source, line);
  std::vector<float> out;
  out.reserve(points.size());
  for (const geom::Vec3& p : points) {
    const auto nearest = scene.nearest(p, 4 * geom::kLargestCoordinate);
    out.push_back(nearest ? static_cast<float>(nearest->distance)
                          : std::numeric_limits<float>::quiet_NaN());
  }
  return out;
}

}  // namespace view
