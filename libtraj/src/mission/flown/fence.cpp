#include "traj/mission/flown/fence.h"

namespace traj {

Fence fence_on_map(const GeodeticFence& fence, const geom::GeodeticOrigin& origin,
                   std::string_view source) {
  const auto side = fence.inclusion ? geom::CircleSide::within : geom::CircleSide::around;
  geom::MapOutline outline = geom::outline_on_map({fence.ring, fence.centre, fence.radius}, origin,
                                                  side, "a fence", source);
  return {fence.inclusion, std::move(outline.ring), outline.bulge};
}

}  // namespace traj
