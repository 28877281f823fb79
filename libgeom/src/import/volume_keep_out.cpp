#include "geom/import/volume_keep_out.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/rounding.h"

namespace geom {
namespace {

constexpr double kLongest = 1e5;    // m, of an edge: bends are taken as those of short ones
constexpr double kRounding = 1e-6;  // m: far more than projecting and turning axes round by

void require_short_edges(const MapOutline& outline, const std::string& what,
                         std::string_view source) {
  const auto& ring = outline.ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double length = (ring[(i + 1) % ring.size()] - ring[i]).norm();
    if (length <= kLongest) continue;
    throw InputError(source, {.item = what,
                              .expected = "edges of at most 100 km",
                              .found = fmt::format("one of {:.0f} km", length / 1000),
                              .advice = "give it more vertices"});
  }
}

class Placing {
 public:
  Placing(std::string_view source, const Frame& frame, const VolumeKeepOutOptions& options)
      : source_(source), frame_(frame), options_(options) {
    if (counts_from_origin(frame)) return;
    throw InputError(
        source,
        {.says =
             "the map has no origin on Earth, so latitudes and longitudes have no place on it"});
  }

  void add(const Volume4d& volume, KeepOut& out) const {
    const std::size_t index = out.volumes.size();
    const std::string what = fmt::format("volume {}", index);
    const MapOutline outline =
        outline_on_map(volume.outline, *frame_.origin, CircleSide::around, what, source_);
    if (!volume.outline.ring.empty()) require_short_edges(outline, what, source_);
    Footprint prism;
    prism.id = index;
    for (const Vec2& p : outline.ring) {
      prism.polygon.outer.push_back(to_enu(frame_.axes, Vec3(p.x(), p.y(), 0)).head<2>());
    }
    if (volume.lower) prism.bottom = add_down(*volume.lower, -zero());
    if (volume.upper) prism.top = add_up(*volume.upper, -zero());
    if (!volume.lower)
      prism.bottom = volume.upper ? std::min(options_.floor, prism.top) : options_.floor;
    if (!volume.upper) prism.top = std::max(options_.ceiling, prism.bottom);
    out.open_below = out.open_below || !volume.lower;
    out.open_above = out.open_above || !volume.upper;
    out.volumes.push_back(std::move(prism));
    out.labels.push_back("keep-out");
    out.bulge.push_back(outline.bulge + kRounding);
  }

 private:
  double zero() const {
    if (options_.height) return *options_.height;
    if (knows_height(frame_)) return frame_.origin->height;
    throw InputError(
        source_,
        {.says = "altitudes of ASTM F3548 are above the ellipsoid, and the map does not say how "
                 "high above it its z = 0 is (0 m, as maps have whose height nobody gave)",
         .advice = "say that height"});
  }

  std::string_view source_;
  const Frame& frame_;
  const VolumeKeepOutOptions& options_;
};

}  // namespace

bool knows_height(const Frame& frame) { return frame.origin && frame.origin->height != 0; }

KeepOut keep_out_of(std::span<const Volume4d> volumes, std::string_view source, const Frame& frame,
                    const VolumeKeepOutOptions& options) {
  const Placing placing(source, frame, options);
  KeepOut out;
  for (const Volume4d& volume : volumes) placing.add(volume, out);
  return out;
}

}  // namespace geom
