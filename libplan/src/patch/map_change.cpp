#include "plan/patch/map_change.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "geom/base/error.h"

namespace plan {
namespace {

using geom::Aabb;

bool before(const Aabb& a, const Aabb& b) {
  const auto key = [](const Aabb& x) {
    return std::array{x.min[0], x.min[1], x.min[2], x.max[0], x.max[1], x.max[2]};
  };
  return key(a) < key(b);
}

std::vector<Aabb> sorted_boxes(const geom::BoxMap& map) {
  std::vector<Aabb> out(map.boxes().begin(), map.boxes().end());
  std::sort(out.begin(), out.end(), before);
  return out;
}

std::vector<Aabb> grown_difference(const std::vector<Aabb>& a, const std::vector<Aabb>& b,
                                   const geom::Vec3& half) {
  std::vector<Aabb> out;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out), before);
  for (Aabb& box : out) box = geom::grow(box, half);
  return out;
}

}  // namespace

MapChange change_since(const geom::BoxMap& before, const geom::CollisionScene& scene) {
  if (!(before.spec().frame == scene.map().spec().frame)) {
    throw geom::InputError(
        "old map", {.expected = "the axes, coordinate reference system and origin of the new map",
                    .found = "others"});
  }
  const std::vector<Aabb> was = sorted_boxes(before);
  const std::vector<Aabb> is = sorted_boxes(scene.map());
  return {grown_difference(was, is, scene.half()), grown_difference(is, was, scene.half())};
}

}  // namespace plan
