#include "traj/mission/file_records.h"

#include <numeric>
#include <utility>

#include "traj/mission/named_aircraft.h"

namespace traj {
namespace {

geom::Polyline whole_path(const FlownLegs& flown) {
  geom::Polyline way = flown.path;
  const auto at = [](const Vec3& p, double z) { return Vec3(p.x(), p.y(), z); };
  if (flown.ends.takeoff_from) way.insert(way.begin(), at(way.front(), *flown.ends.takeoff_from));
  if (flown.ends.landing_on && *flown.ends.landing_on < way.back().z()) {
    way.push_back(at(way.back(), *flown.ends.landing_on));
  }
  return way;
}

}  // namespace

std::optional<geom::PathRecord> path_record(const FileFlight& file,
                                            const geom::Provenance& provenance, bool with_ends) {
  const FlownLegs* legs = legs_of(file.flown);
  if (!legs) return std::nullopt;
  geom::PathRecord record;
  record.id = file.id;
  record.status = geom::PathStatus::found;
  record.provenance = made_for(file, provenance);
  record.points = with_ends ? whole_path(*legs) : legs->path;
  if (!with_ends) record.hold = legs->hold;
  return record;
}

TrajectoryRecord trajectory_record(const FileFlight& file, const geom::Provenance& provenance) {
  TrajectoryRecord record;
  record.id = file.id;
  record.status = TrajectoryStatus::solved;
  record.provenance = made_for(file, provenance);
  record.trajectory = trajectory_of(file.flown);
  return record;
}

std::optional<CorridorShape> regions_record(const FileFlight& file,
                                            const geom::Provenance& provenance) {
  const FlownMission* mission = mission_of(file.flown);
  if (!mission) return std::nullopt;
  CorridorShape shape{file.id, made_for(file, provenance), {}};
  const auto add = [&shape](std::vector<Vec3> polygon) {
    CorridorShape::Piece& piece = shape.pieces.emplace_back();
    std::vector<std::uint32_t>& face = piece.faces.emplace_back(polygon.size());
    std::iota(face.begin(), face.end(), 0u);
    piece.vertices = std::move(polygon);
  };
  if (mission->terrain) {
    for (std::size_t i = 0; i < mission->leg_band.size(); ++i) {
      const Vec3 up(0, 0, mission->leg_band[i]);
      const Vec3& a = mission->path[i];
      const Vec3& b = mission->path[i + 1];
      if ((b - a).head<2>().norm() > 0) add({a - up, b - up, b + up, a + up});
    }
  } else {
    for (const Sweep& sweep : mission->sweeps) {
      if (sweep.hull.size() >= 3) add(sweep.hull);
    }
  }
  if (shape.pieces.empty()) return std::nullopt;
  return shape;
}

}  // namespace traj
