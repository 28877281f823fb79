#include "traj/mission/flown/fence_boxes.h"

#include <vector>

#include "geom/base/usage_error.h"
#include "geom/map/geographic_frame.h"
#include "geom/shape/cover.h"

namespace traj {
namespace {

using geom::Vec2;

// A rectangle around the bounds and the ring.
std::vector<Vec2> around(const geom::Aabb& bounds, const std::vector<Vec2>& ring) {
  Vec2 low = bounds.min.head<2>();
  Vec2 high = bounds.max.head<2>();
  for (const Vec2& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  low.array() -= 1;
  high.array() += 1;
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

// What the fence forbids.
geom::Polygon forbidden(const Fence& fence, const geom::Aabb& bounds) {
  if (fence.inclusion) return {around(bounds, fence.ring), {fence.ring}};
  return {fence.ring, {}};
}

}  // namespace

void require_place_for_fences(const geom::BoxMapSpec& spec) {
  if (geom::counts_from_origin(spec.frame)) return;
  throw geom::UsageError("the map has no origin on Earth, so a fence has no place on it");
}

geom::BoxTable fence_boxes(std::span<const GeodeticFence> fences, const std::string& source,
                           const geom::BoxMapSpec& spec, const geom::VolumeOptions& options) {
  require_place_for_fences(spec);
  geom::BoxTable table;
  table.labels = {"", "fence"};
  std::uint64_t feature = 0;
  for (const GeodeticFence& one : fences) {
    Fence fence = fence_on_map(one, *spec.frame.origin, source);
    for (Vec2& p : fence.ring) {
      p = geom::to_enu(spec.frame.axes, {p.x(), p.y(), 0}).head<2>();
    }
    geom::require_near(spec, {fence.ring}, options.far, feature, source);
    const geom::Polygon polygon = forbidden(fence, spec.bounds);
    geom::refuse_long_stairs(polygon, options.slack, source, feature);
    const Vec2 bulge = Vec2::Constant(fence.bulge);
    for (const geom::Rectangle& r : geom::cover(polygon, options.slack)) {
      const Vec2 low = (r.min - bulge).cwiseMax(spec.bounds.min.head<2>());
      const Vec2 high = (r.max + bulge).cwiseMin(spec.bounds.max.head<2>());
      if ((low.array() > high.array()).any()) continue;
      table.add(
          {{low.x(), low.y(), spec.bounds.min.z()}, {high.x(), high.y(), spec.bounds.max.z()}},
          feature, 1);
    }
    ++feature;
  }
  return table;
}

}  // namespace traj
