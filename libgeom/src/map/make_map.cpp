#include "geom/map/make_map.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "require_bounds.h"

namespace geom {
namespace {

constexpr double kFurthestFromOrigin = 2e5;  // metres

Aabb scaled(const Aabb& box, double factor) {
  Aabb out;
  for (int i = 0; i < 3; ++i) {
    out.min[i] = multiply_down(box.min[i], factor);
    out.max[i] = multiply_up(box.max[i], factor);
  }
  return out;
}

void resize(BoxTable& table, std::string_view source, const MakeMapOptions& options) {
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    Aabb& box = table.boxes[i];
    if (options.scale != 1) box = scaled(box, options.scale);
    if (options.bloat_percent > 0) {
      box = grow(box, (box.max - box.min) * (options.bloat_percent / 200));
    }
    if (options.inflate > 0) box = grow(box, Vec3::Constant(options.inflate));
    if (!(box.min.cwiseAbs().maxCoeff() <= kLargestCoordinate &&
          box.max.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
      throw InputError(
          source, {.says = fmt::format("expected boxes within 1e8 m of the origin, once "
                                       "scaled and grown; found box {} of the source from "
                                       "[{}, {}, {}] to [{}, {}, {}]",
                                       table.ids[i], box.min[0], box.min[1], box.min[2], box.max[0],
                                       box.max[1], box.max[2])});
    }
  }
}

std::size_t seal_to_floor(BoxTable& table, double floor, double seal) {
  std::size_t sealed = 0;
  for (Aabb& box : table.boxes) {
    if (box.min.z() > floor && box.min.z() - floor < seal) {
      box.min.z() = floor;
      ++sealed;
    }
  }
  return sealed;
}

// Numbers that count from an origin on Earth count from near it: those of a country's projection
// would put the map, and home, into another country.
void require_near_origin(const BoxTable& table, const Frame& frame, std::string_view source) {
  if (!frame.origin || !frame.crs.empty()) return;
  const Aabb all = *bounds(table.boxes);
  const Vec3 nearest = Vec3::Zero().cwiseMax(all.min).cwiseMin(all.max);
  const double away = nearest.head<2>().norm();
  if (away <= kFurthestFromOrigin) return;
  throw InputError(
      source,
      {.says = fmt::format("expected coordinates in metres from the origin, latitude {}, longitude "
                           "{}; found the nearest box {:.0f} km away. They seem to count from "
                           "another place, as those of a map projection do: convert them first",
                           frame.origin->latitude, frame.origin->longitude, away / 1000)});
}

}  // namespace

MadeMap make_map(BoxTable table, Frame frame, std::string history, std::string_view source,
                 const MakeMapOptions& options) {
  resize(table, source, options);
  require_near_origin(table, frame, source);
  BoxMapSpec spec;
  spec.frame = std::move(frame);
  spec.history = std::move(history);
  spec.tile_size = options.tile_size;
  const bool given = options.bounds || options.source_bounds;
  if (given) {
    spec.bounds = options.bounds ? *options.bounds : scaled(*options.source_bounds, options.scale);
  } else {
    spec.bounds = *bounds(table.boxes);
    const double pad = options.pad.value_or(0);
    spec.bounds.min -= Vec3(pad, pad, 0);
    spec.bounds.max += Vec3(pad, pad, options.headroom.value_or(pad));
  }
  if (!options.bounds && options.floor) spec.bounds.min.z() = *options.floor;
  if (!options.bounds && options.ceiling) spec.bounds.max.z() = *options.ceiling;
  spec.bounds_from = options.bounds ? "option" : options.source_bounds ? "source" : "obstacles";
  require_bounds(spec.bounds, source);
  const std::size_t sealed = seal_to_floor(table, spec.bounds.min.z(), options.seal.value_or(0));
  std::size_t beyond = 0;
  for (const Aabb& box : table.boxes) beyond += !overlap(box, spec.bounds);
  return {BoxMap(std::move(spec), table), sealed, beyond};
}

}  // namespace geom
