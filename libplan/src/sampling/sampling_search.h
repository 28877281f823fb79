#pragma once

// What the sampling planners share: samples, the growing tree, and the result.

#include <algorithm>
#include <optional>

#include "geom/base/random.h"
#include "plan/sampling/rrt.h"

namespace plan {

// What every method works with: one search, from its first sample to its result.
class SamplingSearch {
 public:
  // The options have all that they may leave open.
  SamplingSearch(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                 const SamplingOptions& options)
      : scene_(scene),
        from_(from),
        to_(to),
        options_(options),
        step_(*options.step),
        most_(*options.iterations),
        region_(region_of(scene, options)),
        random_(options.seed) {}

 protected:
  // By value: nodes move while the tree grows.
  Vec3 point(std::uint32_t node) const { return result_.tree.points[node]; }
  std::size_t size() const { return result_.tree.points.size(); }

  // Whether there is another iteration to do, which is counted.
  bool next_iteration() {
    if (result_.iterations == most_) return false;
    if (options_.stop && result_.iterations % kAskStop == 0 && options_.stop()) {
      result_.stopped = true;
      return false;
    }
    ++result_.iterations;
    return true;
  }

  Vec3 sample_bounds() {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      p[k] = std::min(random_.uniform(region_.min[k], region_.max[k]), region_.max[k]);
    }
    return p;
  }

  Vec3 sample_ball() {
    for (;;) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = random_.uniform(-1, 1);
      if (p.squaredNorm() <= 1) return p;
    }
  }

  Vec3 sample_bounds_or_goal() {
    return random_.chance(options_.goal_bias) ? to_ : sample_bounds();
  }

  std::uint32_t add_root(const Vec3& p, std::uint8_t tree) {
    return add(p, static_cast<std::uint32_t>(size()), tree, 0);
  }

  std::uint32_t add_child(const Vec3& p, std::uint32_t parent) {
    return add(p, parent, result_.tree.tree[parent],
               result_.tree.cost[parent] + (p - point(parent)).norm());
  }

  // EXTEND without the new node: where one step from `near` towards `target` ends, if that is
  // progress and free. What is within a step of the target ends there exactly.
  std::optional<Vec3> step_towards(std::uint32_t near, const Vec3& target) const {
    const Vec3 at = point(near);
    const double distance = (target - at).norm();
    const Vec3 p = distance <= step_ ? target : Vec3(at + (target - at) * (step_ / distance));
    if (p == at || !scene_.free(at, p)) return std::nullopt;
    return p;
  }

  bool sees_goal_within_step(std::uint32_t node) const {
    return (to_ - point(node)).norm() <= step_ && scene_.free(point(node), to_);
  }

  geom::Polyline path_to_root(std::uint32_t node) const {
    geom::Polyline path = {point(node)};
    for (; result_.tree.parent[node] != node; path.push_back(point(node))) {
      node = result_.tree.parent[node];
    }
    return path;
  }

  void found_first(double length) {
    result_.found = true;
    result_.first_found = result_.iterations;
    result_.first_length = length;
  }

  const geom::CollisionScene& scene_;
  const Vec3 from_;
  const Vec3 to_;
  const SamplingOptions& options_;
  const double step_;
  const std::size_t most_;   // iterations
  const geom::Aabb region_;  // of samples
  geom::SplitMix64 random_;
  SamplingResult result_;

 private:
  static constexpr std::size_t kAskStop = 16;  // iterations

  static geom::Aabb region_of(const geom::CollisionScene& scene, const SamplingOptions& options) {
    const geom::Aabb& bounds = *scene.free_bounds();
    if (!options.region || !geom::overlap(*options.region, bounds)) return bounds;
    return {bounds.min.cwiseMax(options.region->min), bounds.max.cwiseMin(options.region->max)};
  }

  std::uint32_t add(const Vec3& p, std::uint32_t parent, std::uint8_t tree, double cost) {
    result_.tree.points.push_back(p);
    result_.tree.parent.push_back(parent);
    result_.tree.first_parent.push_back(parent);
    result_.tree.tree.push_back(tree);
    result_.tree.cost.push_back(cost);
    return static_cast<std::uint32_t>(size() - 1);
  }
};

}  // namespace plan
