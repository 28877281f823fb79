#include "volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/file/files.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/import/keep_out.h"
#include "geom/import/volume_keep_out.h"
#include "geom/map/join.h"
#include "geom/record/volume4d.h"
#include "geom/shape/cover.h"
#include "geom/text/counted.h"
#include "geom/text/instant.h"
#include "geom/text/parse_json.h"
#include "traj/mission/formats/fence_file.h"

namespace verbs {
namespace {

using geom::Vec2;
using geom::Vec3;

// A sloping side is covered by a stair of boxes as high as the slack: so many steps, and no more
// than seconds.
void refuse_long_stairs(const geom::Polygon& polygon, double slack, const std::string& name,
                        std::uint64_t feature) {
  constexpr double kMostPieces = 1e4;
  double longest = 0;
  const auto look_at = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 d = (ring[(i + 1) % ring.size()] - ring[i]).cwiseAbs();
      if (d.minCoeff() > 0) longest = std::max(longest, d.maxCoeff());
    }
  };
  look_at(polygon.outer);
  std::for_each(polygon.holes.begin(), polygon.holes.end(), look_at);
  if (longest <= kMostPieces * slack) return;
  throw geom::InputError(
      name, {.item = fmt::format("feature {}", feature),
             .expected = fmt::format("sloping sides of at most {:.6g} m (1e4 times --slack)",
                                     kMostPieces * slack),
             .found = fmt::format("one of {:.6g} m", longest),
             .advice = fmt::format("give --slack {:.3g} or more, or cut the volume to the map",
                                   std::ceil(longest / kMostPieces))});
}

// One JSON value in the form of ASTM F3548, and not of GeoJSON.
bool is_f3548(const std::string& text, const std::string& name) {
  const nlohmann::ordered_json root = geom::parse_ordered_json(text, name);
  if (!root.is_object()) return root.is_array();
  for (const char* key : {"volume", "volumes", "off_nominal_volumes", "details",
                          "operational_intent", "constraint"}) {
    if (root.contains(key)) return true;
  }
  return false;
}

// When a volume is there, rounded outward.
geom::TimeSpan time_of(const geom::Volume4d& volume, const std::optional<std::string>& epoch,
                       const std::string& name) {
  geom::TimeSpan out;
  if (!volume.start && !volume.end) return out;
  if (!epoch) {
    throw geom::InputError(
        name, {.says = "the times of its volumes count from an epoch, and the map has none",
               .advice = "give --epoch"});
  }
  if (volume.start) out.from = geom::seconds_between(*epoch, *volume.start).least;
  if (volume.end) out.until = geom::seconds_between(*epoch, *volume.end).most;
  if (const auto fault = geom::span_fault(out)) throw geom::InputError(name, *fault);
  return out;
}

geom::KeepOut f3548_zones(const std::string& text, const std::string& name,
                          const Volumes& volumes) {
  std::istringstream in(text);
  const geom::BoxMapSpec& spec = volumes.spec;
  const std::vector<geom::Volume4d> read = geom::read_volumes_4d(in, name);
  geom::KeepOut zones = geom::keep_out_of(
      read, name, spec.frame, {volumes.zero_height, spec.bounds.min.z(), spec.bounds.max.z()});
  for (const geom::Volume4d& volume : read) {
    zones.times.push_back(time_of(volume, spec.epoch, name));
  }
  return zones;
}

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

void Volumes::require_near(const DrawnRing& outline, std::uint64_t feature,
                           const std::string& name) const {
  if (far) return;
  if (const auto why = why_not_near(spec, outline)) {
    throw geom::InputError(name,
                           {.item = fmt::format("feature {}", feature), .says = std::string(*why)});
  }
}

geom::BoxTable Volumes::keep_out(const std::string& path, bool local,
                                 const cli::MetresOption& metres, const cli::Common& common) const {
  cli::InputFile file(path);
  const std::string text = file.read_all();
  const bool f3548 = is_f3548(text, file.name());
  if (f3548 && local) {
    throw cli::UsageError("--keep-out-local: volumes of ASTM F3548 are in degrees");
  }
  if (!f3548 && zero_height) {
    throw cli::UsageError("--zero-height: the altitudes of GeoJSON are in the map's z already");
  }
  std::istringstream in(text);
  const geom::KeepOut zones =
      f3548 ? f3548_zones(text, file.name(), *this)
            : geom::read_keep_out(in, file.name(), spec.frame,
                                  {local, spec.bounds.min.z(), spec.bounds.max.z(), spec.epoch});
  if (local) require_metres(zones, spec.frame, file.name(), metres);
  warn_of_unread(zones, file.name(), common);
  geom::BoxTable table;
  for (std::size_t i = 0; i < zones.volumes.size(); ++i) {
    const geom::Footprint& zone = zones.volumes[i];
    require_near({zone.polygon.outer, !f3548 && !local}, zone.id, file.name());
    refuse_long_stairs(zone.polygon, slack, file.name(), zone.id);
    geom::BoxTable one;
    one.labels = {"", zones.labels[i]};
    const Vec3 bulge(zones.bulge[i], zones.bulge[i], 0);
    for (const geom::Rectangle& r : geom::cover(zone.polygon, slack)) {
      one.add({Vec3(r.min.x(), r.min.y(), zone.bottom) - bulge,
               Vec3(r.max.x(), r.max.y(), zone.top) + bulge},
              zone.id, 1);
      one.set_time(one.boxes.size() - 1, zones.times[i]);
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
    require_near({fence.ring}, feature, file.name());
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
