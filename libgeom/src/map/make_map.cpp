#include "geom/map/make_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/base/rounding.h"
#include "require_bounds.h"
#include "tile_sort.h"

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

constexpr std::size_t kStretch = std::size_t{1} << 16;  // boxes that a thread takes at once

// Calls f(part, boxes) for parts of the table that are the same for any number of threads.
template <class F>
void for_parts(BoxTable& table, const Execution& run, const F& f) {
  const std::size_t n = table.boxes.size();
  parallel_for((n + kStretch - 1) / kStretch, {run.threads, {}}, [&](std::size_t part) {
    const std::size_t begin = part * kStretch;
    f(part, std::span(table.boxes).subspan(begin, std::min(kStretch, n - begin)));
  });
}

Aabb resized(Aabb box, const MakeMapOptions& options) {
  if (options.scale != 1) box = scaled(box, options.scale);
  if (options.bloat_percent > 0) {
    box = grow(box, (box.max - box.min) * (options.bloat_percent / 200));
  }
  if (options.inflate > 0) box = grow(box, Vec3::Constant(options.inflate));
  return box;
}

// Gives all boxes the size that the options ask for, and gives what is around them.
Aabb resize(BoxTable& table, std::string_view source, const MakeMapOptions& options,
            const Execution& run) {
  const bool changes = options.scale != 1 || options.bloat_percent > 0 || options.inflate > 0;
  std::vector<Aabb> around(table.boxes.size() / kStretch + 1, table.boxes.front());
  for_parts(table, run, [&](std::size_t part, std::span<Aabb> boxes) {
    if (changes) {
      for (Aabb& box : boxes) box = resized(box, options);
    }
    around[part] = *bounds(boxes);
  });
  around.resize((table.boxes.size() + kStretch - 1) / kStretch);
  const Aabb all = *bounds(around);
  if (!is_within_reach(all)) require_within_reach(table, source);
  return all;
}

// Of obstacles: how many were let down to the floor, and are outside the bounds.
struct Sealed {
  std::size_t sealed = 0;
  std::size_t beyond = 0;
};

Sealed seal_to_floor(BoxTable& table, const Aabb& inside, double seal, const Execution& run) {
  const double floor = inside.min.z();
  std::vector<Sealed> parts(table.boxes.size() / kStretch + 1);
  for_parts(table, run, [&](std::size_t part, std::span<Aabb> boxes) {
    Sealed count;
    for (Aabb& box : boxes) {
      if (box.min.z() > floor && box.min.z() - floor < seal) {
        box.min.z() = floor;
        ++count.sealed;
      }
      count.beyond += !overlap(box, inside);
    }
    parts[part] = count;
  });
  Sealed all;
  for (const Sealed& part : parts) all = {all.sealed + part.sealed, all.beyond + part.beyond};
  return all;
}

// Numbers that count from an origin on Earth count from near it: those of a country's projection
// would put the map, and home, into another country.
void require_near_origin(const Aabb& all, const Frame& frame, std::string_view source) {
  if (!frame.origin || !frame.crs.empty()) return;
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
                 const MakeMapOptions& options, const Execution& run) {
  const Aabb around = resize(table, source, options, run);
  require_near_origin(around, frame, source);
  BoxMapSpec spec;
  spec.frame = std::move(frame);
  spec.history = std::move(history);
  spec.tile_size = options.tile_size;
  const bool given = options.bounds || options.source_bounds;
  if (given) {
    spec.bounds = options.bounds ? *options.bounds : scaled(*options.source_bounds, options.scale);
  } else {
    spec.bounds = around;
    const double pad = options.pad.value_or(0);
    spec.bounds.min -= Vec3(pad, pad, 0);
    spec.bounds.max += Vec3(pad, pad, options.headroom.value_or(pad));
  }
  if (!options.bounds && options.floor) spec.bounds.min.z() = *options.floor;
  if (!options.bounds && options.ceiling) spec.bounds.max.z() = *options.ceiling;
  spec.bounds_from = options.bounds ? "option" : options.source_bounds ? "source" : "obstacles";
  require_bounds(spec.bounds, source);
  const Sealed count = seal_to_floor(table, spec.bounds, options.seal.value_or(0), run);
  return {box_map_of(std::move(spec), table, run), count.sealed, count.beyond};
}

}  // namespace geom
