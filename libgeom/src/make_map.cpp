#include "geom/make_map.h"

#include <fmt/format.h>

#include "geom/error.h"

namespace geom {
namespace {

Aabb bounding_box(const BoxTable& table) {
  Aabb all = table.boxes.front();
  for (const Aabb& box : table.boxes) all = merged(all, box);
  return all;
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

}  // namespace

MadeMap make_map(BoxTable table, Frame frame, std::string history, std::string_view source,
                 const MakeMapOptions& options) {
  BoxMapSpec spec;
  spec.frame = std::move(frame);
  spec.history = std::move(history);
  spec.tile_size = options.tile_size;
  const bool given = options.bounds || options.source_bounds;
  if (given) {
    spec.bounds = options.bounds ? *options.bounds : *options.source_bounds;
  } else {
    spec.bounds = bounding_box(table);
    const Vec3 low(options.pad, options.pad, 0);
    spec.bounds.min -= low;
    spec.bounds.max += Vec3::Constant(options.pad);
  }
  if (!options.bounds && options.floor) spec.bounds.min.z() = *options.floor;
  if (!options.bounds && options.ceiling) spec.bounds.max.z() = *options.ceiling;
  spec.bounds_from = options.bounds ? "option" : options.source_bounds ? "source" : "obstacles";
  if ((spec.bounds.min.array() >= spec.bounds.max.array()).any()) {
    throw InputError(source,
                     fmt::format("the bounds must have min < max on every axis, found "
                                 "[{}, {}, {}] to [{}, {}, {}]",
                                 spec.bounds.min[0], spec.bounds.min[1], spec.bounds.min[2],
                                 spec.bounds.max[0], spec.bounds.max[1], spec.bounds.max[2]));
  }
  const std::size_t sealed = seal_to_floor(table, spec.bounds.min.z(), options.seal);
  std::size_t beyond = 0;
  for (const Aabb& box : table.boxes) beyond += !overlap(box, spec.bounds);
  return {BoxMap(std::move(spec), table), sealed, beyond};
}

}  // namespace geom
