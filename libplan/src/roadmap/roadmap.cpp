#include "plan/roadmap/roadmap.h"

#include <algorithm>

#include "bends.h"

namespace plan {

std::vector<Bend> bends_along(const geom::CollisionScene& scene, double part,
                              const geom::Polyline& path, double width) {
  constexpr double kPiece = 50;  // metres: bounding boxes of longer ones would hold too much
  std::vector<std::size_t> near;
  const geom::Polyline pieces = geom::resample(path, kPiece);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const geom::Aabb piece{pieces[i - 1].cwiseMin(pieces[i]), pieces[i - 1].cwiseMax(pieces[i])};
    for (const std::size_t box : scene.boxes_meeting(geom::grow(piece, Vec3::Constant(width)))) {
      near.push_back(box);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Bend> bends;
  for (const std::size_t i : near) add_bends(scene, scene.grown(i), part, std::nullopt, bends);
  return bends;
}

}  // namespace plan
