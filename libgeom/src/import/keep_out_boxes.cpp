#include "geom/import/keep_out_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/base/usage_error.h"
#include "geom/import/volume_keep_out.h"
#include "geom/record/volume4d.h"
#include "geom/shape/cover.h"
#include "geom/text/instant.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

// One JSON value in the form of ASTM F3548, and not of GeoJSON.
bool is_f3548(const std::string& text, const std::string& source) {
  const nlohmann::ordered_json root = parse_ordered_json(text, source);
  if (!root.is_object()) return root.is_array();
  for (const char* key : {"volume", "volumes", "off_nominal_volumes", "details",
                          "operational_intent", "constraint"}) {
    if (root.contains(key)) return true;
  }
  return false;
}

// When a volume is there, rounded outward.
TimeSpan time_of(const Volume4d& volume, const std::optional<std::string>& epoch,
                 const std::string& source) {
  TimeSpan out;
  if (!volume.start && !volume.end) return out;
  if (!epoch) {
    throw InputError(source,
                     {.says = "the times of its volumes count from an epoch, and the map has none",
                      .advice = "give --epoch"});
  }
  if (volume.start) out.from = seconds_between(*epoch, *volume.start).least;
  if (volume.end) out.until = seconds_between(*epoch, *volume.end).most;
  if (const auto fault = span_fault(out)) throw InputError(source, *fault);
  return out;
}

KeepOut f3548_zones(const std::string& text, const std::string& source, const BoxMapSpec& spec,
                    const std::optional<double>& zero_height) {
  TextInput in(text);
  const std::vector<Volume4d> read = read_volumes_4d(in, source);
  KeepOut zones = keep_out_of(read, source, spec.frame,
                              {zero_height, spec.bounds.min.z(), spec.bounds.max.z()});
  for (const Volume4d& volume : read) zones.times.push_back(time_of(volume, spec.epoch, source));
  return zones;
}

}  // namespace

void refuse_long_stairs(const Polygon& polygon, double slack, const std::string& source,
                        std::uint64_t feature) {
  constexpr double kMostPieces = 1e4;  // no more than seconds
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
  throw InputError(
      source, {.item = fmt::format("feature {}", feature),
               .expected = fmt::format("sloping sides of at most {:.6g} m (1e4 times --slack)",
                                       kMostPieces * slack),
               .found = fmt::format("one of {:.6g} m", longest),
               .advice = fmt::format("give --slack {:.3g} or more, or cut the volume to the map",
                                     std::ceil(longest / kMostPieces))});
}

void require_near(const BoxMapSpec& spec, const DrawnRing& outline, bool far, std::uint64_t feature,
                  const std::string& source) {
  if (far) return;
  if (const auto why = why_not_near(spec, outline)) {
    throw InputError(source, {.item = fmt::format("feature {}", feature), .says = *why});
  }
}

KeepOut read_volumes(const std::string& text, const std::string& source, const BoxMapSpec& spec,
                     const VolumeOptions& options) {
  const bool f3548 = is_f3548(text, source);
  if (f3548 && options.local) {
    throw UsageError("--keep-out-local: volumes of ASTM F3548 are in degrees");
  }
  if (!f3548 && options.zero_height) {
    throw UsageError("--zero-height: the altitudes of GeoJSON are in the map's z already");
  }
  KeepOut zones;
  if (f3548) {
    zones = f3548_zones(text, source, spec, options.zero_height);
  } else {
    TextInput in(text);
    zones = read_keep_out(in, source, spec.frame,
                          {options.local, spec.bounds.min.z(), spec.bounds.max.z(), spec.epoch});
  }
  zones.longitude_first = !f3548 && !options.local;
  return zones;
}

BoxTable keep_out_boxes(const KeepOut& zones, const std::string& source, const BoxMapSpec& spec,
                        const VolumeOptions& options) {
  BoxTable table;
  for (std::size_t i = 0; i < zones.volumes.size(); ++i) {
    const Footprint& zone = zones.volumes[i];
    require_near(spec, {zone.polygon.outer, zones.longitude_first}, options.far, zone.id, source);
    refuse_long_stairs(zone.polygon, options.slack, source, zone.id);
    BoxTable one;
    one.labels = {"", zones.labels[i]};
    const Vec3 bulge(zones.bulge[i], zones.bulge[i], 0);
    for (const Rectangle& r : cover(zone.polygon, options.slack)) {
      one.add({Vec3(r.min.x(), r.min.y(), zone.bottom) - bulge,
               Vec3(r.max.x(), r.max.y(), zone.top) + bulge},
              zone.id, 1);
      one.set_time(one.boxes.size() - 1, zones.times[i]);
    }
    append(table, one);
  }
  return table;
}

}  // namespace geom
