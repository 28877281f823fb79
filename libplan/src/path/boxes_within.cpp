#include "boxes_within.h"

#include <algorithm>

namespace plan {
namespace {

constexpr double kCell = 60;       // metres: the widest region that is asked at once
constexpr std::size_t kAgain = 4;  // how often a box may be found, for it lies in several regions

// Adds the boxes of the region, halved until it is small; whether these are few enough.
bool add_boxes(const geom::CollisionScene& scene, const ShortWays& ways, const geom::Aabb& region,
               std::size_t most, std::vector<std::size_t>& out) {
  if (!ways.may_meet(region)) return true;
  const geom::Vec3 size = region.max - region.min;
  const int k = size.x() > size.y() ? 0 : 1;
  if (size[k] <= kCell) {
    const auto found = scene.boxes_meeting(region);
    out.insert(out.end(), found.begin(), found.end());
    return out.size() <= most;
  }
  geom::Aabb low = region;
  geom::Aabb high = region;
  low.max[k] = high.min[k] = 0.5 * (region.min[k] + region.max[k]);
  return add_boxes(scene, ways, low, most, out) && add_boxes(scene, ways, high, most, out);
}

}  // namespace

std::optional<std::vector<std::size_t>> boxes_within(const geom::CollisionScene& scene,
                                                     const ShortWays& ways, std::size_t most) {
  std::vector<std::size_t> boxes;
  if (!add_boxes(scene, ways, ways.around(), kAgain * most, boxes)) return std::nullopt;
  std::sort(boxes.begin(), boxes.end());
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  std::erase_if(boxes, [&](std::size_t i) { return !ways.may_meet(scene.grown(i)); });
  if (boxes.size() > most) return std::nullopt;
  return boxes;
}

}  // namespace plan
