#include "surface_heights.h"

#include <fmt/format.h>

#include <utility>

#include "geom/base/error.h"
#include "geom/base/rounding.h"

namespace traj {

SurfaceRange SurfaceHeights::over(std::span<const Vec3> places) const {
  const geom::Aabb box = *geom::bounds(places);
  const geom::Vec2 by = geom::Vec2::Constant(around_);
  geom::Rectangle at{box.min.head<2>() - by, box.max.head<2>() + by};
  if (rules_.axes != geom::Axes::enu) {
    std::swap(at.min.x(), at.min.y());
    std::swap(at.max.x(), at.max.y());
  }
  const geom::GroundRange ground = rules_.ground->range(at);
  if (!ground.all_known) {
    throw geom::InputError(
        source_,
        {.expected = "a height model that knows the ground below the whole way, since the "
                     "aircraft follows the surface there",
         .found = fmt::format("a hole, or its end, at x {:.6g} to {:.6g}, y {:.6g} to {:.6g}",
                              at.min.x(), at.max.x(), at.min.y(), at.max.y()),
         .advice = "take a larger height model (and map)"});
  }
  return {geom::add_down(ground.low, rules_.surface->low),
          geom::add_up(ground.high, rules_.surface->high)};
}

Hull SurfaceHeights::raised(std::span<const Vec3> places) const {
  const SurfaceRange heights = over(places);
  Hull out;
  for (const Vec3& p : places) {
    out.emplace_back(p.x(), p.y(), heights.low);
    out.emplace_back(p.x(), p.y(), heights.high);
  }
  return out;
}

}  // namespace traj
