#include "volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/file/files.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/import/keep_out.h"
#include "geom/map/join.h"
#include "geom/shape/cover.h"
#include "traj/drone_file/fence_file.h"

namespace verbs {
namespace {

using geom::Vec2;
using geom::Vec3;

// A sloping side is covered by a stair of boxes as high as the slack: so many steps, and no more
// than seconds.
void refuse_long_stairs(const geom::Polygon& polygon, double slack, const std::string& name,
                        std::uint64_t feature) {
  constexpr double kMostSteps = 1e4;
  double longest = 0;
  const auto look_at = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 d = (ring[(i + 1) % ring.size()] - ring[i]).cwiseAbs();
      if (d.minCoeff() > 0) longest = std::max(longest, d.maxCoeff());
    }
  };
  look_at(polygon.outer);
  std::for_each(polygon.holes.begin(), polygon.holes.end(), look_at);
  if (longest <= kMostSteps * slack) return;
  throw geom::InputError(
      name,
      fmt::format("feature {}: expected sloping sides of at most {:.6g} m (1e4 times --slack), "
                  "found one of {:.6g} m: give --slack {:.3g} or more, or cut the volume to the "
                  "map",
                  feature, kMostSteps * slack, longest, std::ceil(longest / kMostSteps)));
}

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

}  // namespace

geom::BoxTable Volumes::keep_out(const std::string& path, bool local) const {
  cli::InputFile file(path);
  const geom::KeepOut zones = geom::read_keep_out(
      file.stream(), file.name(), spec.frame, {local, spec.bounds.min.z(), spec.bounds.max.z()});
  geom::BoxTable table;
  for (std::size_t i = 0; i < zones.volumes.size(); ++i) {
    const geom::Footprint& zone = zones.volumes[i];
    refuse_long_stairs(zone.polygon, slack, file.name(), zone.id);
    geom::BoxTable one;
    one.labels = {"", zones.labels[i]};
    const Vec3 bulge(zones.bulge[i], zones.bulge[i], 0);
    for (const geom::Rectangle& r : geom::cover(zone.polygon, slack)) {
      one.add({Vec3(r.min.x(), r.min.y(), zone.bottom) - bulge,
               Vec3(r.max.x(), r.max.y(), zone.top) + bulge},
              zone.id, 1);
    }
    geom::append(table, one);
  }
  return table;
}

geom::BoxTable Volumes::fence(const std::string& path) const {
  if (!geom::counts_from_origin(spec.frame)) {
    throw cli::UsageError("the map has no origin on Earth, so a fence has no place on it");
  }
  cli::InputFile file(path);
  geom::BoxTable table;
  table.labels = {"", "fence"};
  std::uint64_t feature = 0;
  for (const traj::GeodeticFence& one : traj::read_fences(file.stream(), file.name())) {
    traj::Fence fence = traj::fence_on_map(one, *spec.frame.origin, file.name());
    for (Vec2& p : fence.ring) {
      p = geom::to_enu(spec.frame.axes, {p.x(), p.y(), 0}).head<2>();
    }
    geom::Polygon polygon{fence.ring, {}};
    if (fence.inclusion) polygon = {around(spec.bounds, fence.ring), {fence.ring}};
    refuse_long_stairs(polygon, slack, file.name(), feature);
    const Vec2 bulge = Vec2::Constant(fence.bulge);
    for (const geom::Rectangle& r : geom::cover(polygon, slack)) {
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

}  // namespace verbs
