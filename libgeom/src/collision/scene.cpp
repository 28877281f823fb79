#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/collision/collision.h"
#include "queries.h"

namespace geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(const Aabb& region) {
  throw InputError(
      "region", {.expected = "min <= max",
                 .found = fmt::format("[{}, {}, {}] to [{}, {}, {}]", region.min[0], region.min[1],
                                      region.min[2], region.max[0], region.max[1], region.max[2])});
}

bool is_near(const Aabb& region) {
  return region.min.lpNorm<1>() + region.max.lpNorm<1>() <= kFarthest;
}

}  // namespace

CollisionScene::CollisionScene(BoxMap map, Vehicle vehicle, double margin,
                               const CollisionOptions& options)
    : impl_(std::make_unique<Impl>(std::move(map), std::move(vehicle), margin, options)) {}
CollisionScene::~CollisionScene() = default;
CollisionScene::CollisionScene(CollisionScene&&) noexcept = default;
CollisionScene& CollisionScene::operator=(CollisionScene&&) noexcept = default;

const BoxMap& CollisionScene::map() const { return impl_->map; }
const Vehicle& CollisionScene::vehicle() const { return impl_->vehicle; }
double CollisionScene::margin() const { return impl_->margin; }
Vec3 CollisionScene::half() const { return impl_->half; }
const std::optional<Aabb>& CollisionScene::free_bounds() const { return impl_->free_bounds; }

bool CollisionScene::inside_bounds(const Vec3& p) const {
  return impl_->free_bounds && contains(*impl_->free_bounds, p);
}

bool CollisionScene::hits(const Vec3& a, const Vec3& b) const {
  require_points("segment", a, b);
  if (impl_->groups.empty()) return false;
  return hits_any(*impl_, a, b);
}

std::optional<Aabb> CollisionScene::blocker(const Vec3& a, const Vec3& b) const {
  require_points("segment", a, b);
  if (impl_->groups.empty()) return std::nullopt;
  return blocking_box(*impl_, a, b);
}

std::vector<std::size_t> CollisionScene::blockers(const Vec3& a, const Vec3& b) const {
  require_points("segment", a, b);
  if (impl_->groups.empty()) return {};
  return blocking_boxes(*impl_, a, b);
}

bool CollisionScene::free(const Vec3& a, const Vec3& b) const {
  return inside_bounds(a) && inside_bounds(b) && !hits(a, b);
}

std::size_t CollisionScene::nearest(const Vec3& p, double radius, std::span<Nearest> room) const {
  require_point("point", p);
  if (std::isnan(radius)) refuse_length("radius", radius, kInfinity);
  if (impl_->groups.empty() || room.empty() || radius < 0) return 0;
  return find_nearest(*impl_, p, radius, room);
}

std::optional<Nearest> CollisionScene::nearest(const Vec3& p, double radius) const {
  Nearest one;
  if (nearest(p, radius, std::span(&one, 1)) == 0) return std::nullopt;
  return one;
}

std::vector<Nearest> CollisionScene::nearest(const Vec3& p, double radius,
                                             std::size_t count) const {
  std::vector<Nearest> list(std::min(count, impl_->map.size()));
  list.resize(nearest(p, radius, std::span(list)));
  return list;
}

std::vector<std::size_t> CollisionScene::boxes_meeting(const Aabb& region) const {
  return *boxes_meeting(region, impl_->map.size());
}

std::optional<std::vector<std::size_t>> CollisionScene::boxes_meeting(const Aabb& region,
                                                                      std::size_t most) const {
  if (!(region.min.array() <= region.max.array()).all()) refuse(region);  // NaN is not <= either
  if (impl_->groups.empty()) return std::vector<std::size_t>();
  if (is_near(region)) return find_meeting(*impl_, region, most);
  // What is cut off has no boxes.
  if (!overlap(region, impl_->reach)) return std::vector<std::size_t>();
  const Aabb part{region.min.cwiseMax(impl_->reach.min), region.max.cwiseMin(impl_->reach.max)};
  return find_meeting(*impl_, part, most);
}

CollisionCounts CollisionScene::counts() const {
  const std::lock_guard lock(impl_->keeping);
  return impl_->counts;
}

Aabb CollisionScene::grown(std::size_t i) const { return grow(impl_->map.box(i), impl_->half); }

}  // namespace geom
