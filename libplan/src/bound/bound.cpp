#include "plan/bound/bound.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "convex_edges.h"
#include "geom/base/error.h"
#include "geom/base/once.h"
#include "geom/base/precondition.h"
#include "occluders.h"
#include "path/boxes_within.h"
#include "search.h"

namespace plan {

namespace {

constexpr std::size_t kWhole = 20'000;  // boxes of a map that is looked at as a whole
constexpr std::size_t kMost = 50'000;   // boxes that a question to a larger map looks at

// What a search is made of: parts of edges, and what stands between them.
struct Obstacles {
  explicit Obstacles(const geom::CollisionScene& scene)
      : parts(parts_of(convex_edges(scene), kPart)), occluders(scene) {}

  PartTree parts;
  Occluders occluders;
};

// Only these boxes of the map, as they are.
geom::CollisionScene of_boxes(const geom::CollisionScene& scene,
                              const std::vector<std::size_t>& boxes) {
  geom::BoxTable table;
  for (const std::size_t i : boxes) table.add(scene.map().box(i), 0);
  return {geom::BoxMap(scene.map().spec(), table), scene.vehicle(), scene.margin()};
}

}  // namespace

struct Bounder::Impl {
  explicit Impl(const geom::CollisionScene& of) : scene(of) {}

  const Obstacles& whole() {
    once.call([&] { obstacles.emplace(scene); });
    return *obstacles;
  }

  // Whoever keeps clear of all boxes keeps clear of some of them, so what no path past these
  // undercuts none undercuts at all; and the others are out of reach of a path that is shorter than
  // the one known. Nothing where they are too many.
  std::optional<Obstacles> around(const ShortWays& ways) const {
    const auto boxes = boxes_within(scene, ways, kMost);
    if (!boxes) return std::nullopt;
    return Obstacles(of_boxes(scene, *boxes));
  }

  const geom::CollisionScene& scene;
  geom::Once once;
  std::optional<Obstacles> obstacles;
};

Bounder::Bounder(const geom::CollisionScene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Bounder::~Bounder() = default;

LengthBound Bounder::ask(const Vec3& from, const Vec3& to, double length,
                         const BoundOptions& options) {
  geom::require_point("start", from);
  geom::require_point("goal", to);
  geom::require_length("length", length, std::numeric_limits<double>::max());
  if (!(options.gap > 0 && options.gap <= 1)) {
    throw geom::InputError(
        "gap", {.expected = "a share above 0 and up to 1", .found = fmt::to_string(options.gap)});
  }
  const auto& bounds = impl_->scene.free_bounds();
  const double straight = (to - from).norm() * (1 - 0x1p-50);
  const double target = bound_for(length, options.gap);
  LengthBound result;
  result.bound = straight;
  result.closed = straight >= target;
  if (options.keep_proof) result.proof.emplace();
  if (result.closed || !bounds || (bounds->max.array() <= bounds->min.array()).any()) return result;
  const Vec3 size = bounds->min.cwiseAbs().cwiseMax(bounds->max.cwiseAbs());
  const double slack = std::ldexp(size.sum() + length, -43);
  std::optional<Obstacles> near;
  const bool whole = impl_->scene.map().size() <= kWhole || options.keep_proof;
  if (!whole) near = impl_->around({from, to, length});
  if (!whole && !near) return result;
  const Obstacles& obstacles = whole ? impl_->whole() : *near;
  BoundSearch search(impl_->scene, obstacles.occluders, options, length, slack);
  result = search.bound(obstacles.parts, from, to);
  result.bound = std::max(result.bound, straight);
  return result;
}

}  // namespace plan
