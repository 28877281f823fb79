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
#include "search.h"

namespace plan {

struct Bounder::Impl {
  explicit Impl(const geom::CollisionScene& of) : scene(of) {}

  void prepare() {
    once.call([&] {
      parts = PartTree(parts_of(convex_edges(scene), kPart));
      occluders.emplace(scene);
    });
  }

  const geom::CollisionScene& scene;
  geom::Once once;
  PartTree parts;
  std::optional<Occluders> occluders;
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
  impl_->prepare();
  BoundSearch search(impl_->scene, *impl_->occluders, options, length, slack);
  result = search.bound(impl_->parts, from, to);
  result.bound = std::max(result.bound, straight);
  return result;
}

}  // namespace plan
