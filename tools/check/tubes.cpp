#include "tubes.h"

#include "cli/file/files.h"
#include "traj/record/check_in_tube.h"

namespace checking {
namespace {

traj::TubeReports tubes_in(const std::string& path) {
  cli::InputFile file(path);
  return traj::TubeReports::read(file.stream(), file.name());
}

}  // namespace

Tubes::Tubes(const std::string& file, const cli::Scenes& scenes, double margin)
    : profile_(scenes.profile()),
      margin_(margin),
      tubes_(tubes_in(file)),
      scenes_(scenes.map(), {}, geom::Differences::refused, scenes.budget()) {}

traj::TubeReport Tubes::check(const geom::CollisionScene& scene,
                              const traj::TrajectoryRecord& record) const {
  geom::Provenance room = geom::provenance_of(scene);
  const traj::TubeRecord& tube = tubes_.require_tube(record.id, record.trajectory, room);
  std::optional<geom::Vec3> body;
  if (profile_ && profile_->vehicle.half == scene.vehicle().half) body = profile_->body;
  room.margin = margin_;
  const auto around = scenes_.shared_scene_for(room, tubes_.source(), 0);
  return traj::check_in_tube(*around, record.id, record.trajectory, tube, body);
}

}  // namespace checking
