#include "volumes.h"

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/run.h"
#include "geom/map/geographic_frame.h"
#include "geom/shape/cover.h"
#include "geom/text/counted.h"
#include "traj/mission/formats/fence_file.h"

namespace verbs {
namespace {

using geom::Vec2;
using geom::Vec3;

// A polygon of degrees is one of parts of a metre, if they are taken for metres.
void require_metres(const geom::KeepOut& zones, const geom::Frame& frame, const std::string& name,
                    const cli::MetresOption& metres) {
  for (const geom::Footprint& zone : zones.volumes) {
    std::vector<Vec3> corners;
    for (const Vec2& p : zone.polygon.outer) corners.emplace_back(p.x(), p.y(), 0);
    metres.check_outline(frame, corners, fmt::format("{}: feature {}", name, zone.id));
  }
}

// Such volumes reach from the bottom of the map to its top.
void warn_of_unread(const geom::KeepOut& zones, const std::string& name,
                    const cli::Common& common) {
  for (const auto& [key, count] : zones.unread) {
    common.warn(fmt::format(
        "{}: \"{}\" of {} is not read: without \"lower\" and \"upper\", metres in the map's z, a "
        "volume reaches from the bottom of the map to its top; without \"from\" and \"until\" it "
        "is always there",
        name, key, geom::counted(count, "volume")));
  }
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

geom::BoxTable keep_out(const std::string& path, const geom::BoxMapSpec& spec,
                        const geom::VolumeOptions& options, const cli::MetresOption& metres,
                        const cli::Common& common) {
  cli::InputFile file(path);
  const geom::KeepOut zones = geom::read_volumes(file.read_all(), file.name(), spec, options);
  if (options.local) require_metres(zones, spec.frame, file.name(), metres);
  warn_of_unread(zones, file.name(), common);
  return geom::keep_out_boxes(zones, file.name(), spec, options);
}

geom::BoxTable fence(const std::string& path, const geom::BoxMapSpec& spec,
                     const geom::VolumeOptions& options) {
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
    geom::require_near(spec, {fence.ring}, options.far, feature, file.name());
    geom::Polygon polygon{fence.ring, {}};
    if (fence.inclusion) polygon = {around(spec.bounds, fence.ring), {fence.ring}};
    geom::refuse_long_stairs(polygon, options.slack, file.name(), feature);
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

}  // namespace verbs
