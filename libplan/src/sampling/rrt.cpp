#include "plan/sampling/rrt.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/base/error.h"
#include "plan/lattice/fitting_length.h"
#include "roadmap/point_index.h"
#include "rrt_star.h"
#include "sampling_search.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr double kStep = 15;    // metres, in a city
constexpr double kRadius = 30;  // metres, in a city
constexpr std::size_t kIterations = 20000;
constexpr std::size_t kSmallIterations = 100000;  // of searches that end with the first path

void check(const SamplingOptions& options) {
  const auto need = [](bool holds, std::string_view what, double found) {
    if (!holds) {
      throw geom::InputError("sampling",
                             {.expected = std::string(what), .found = fmt::to_string(found)});
    }
  };
  const double step = options.step.value_or(kStep);
  const double radius = options.radius.value_or(kRadius);
  need(step > 0, "a step > 0 metres", step);
  need(options.goal_bias >= 0 && options.goal_bias <= 1, "a goal bias in [0, 1]",
       options.goal_bias);
  need(radius >= 0, "a radius >= 0 metres", radius);
  const std::size_t iterations = options.iterations.value_or(kIterations);
  need(iterations >> 31 == 0, "fewer than 2^31 iterations",  // nodes have 32-bit indices
       static_cast<double>(iterations));
}

class Rrt : SamplingSearch {
 public:
  using SamplingSearch::SamplingSearch;

  SamplingResult run() {
    index_.insert(from_, add_root(from_, 0));
    while (next_iteration()) {
      const Vec3 sample = sample_bounds_or_goal();
      const std::uint32_t near = index_.nearest(sample);
      const auto p = step_towards(near, sample);
      if (!p) continue;
      std::uint32_t node = add_child(*p, near);
      index_.insert(*p, node);
      if (*p != to_) {
        if (!sees_goal_within_step(node)) continue;
        node = add_child(to_, node);
      }
      found_first(result_.tree.cost[node]);
      result_.path = path_to_root(node);
      std::reverse(result_.path.begin(), result_.path.end());
      break;
    }
    return std::move(result_);
  }

 private:
  PointIndex index_;
};

class RrtConnect : SamplingSearch {
 public:
  using SamplingSearch::SamplingSearch;

  SamplingResult run() {
    index_[0].insert(from_, add_root(from_, 0));
    index_[1].insert(to_, add_root(to_, 1));
    for (std::size_t side = 0; next_iteration(); side = 1 - side) {
      const Vec3 sample = sample_bounds();
      const auto node = extend(side, index_[side].nearest(sample), sample);
      if (!node) continue;
      const auto met = connect(1 - side, point(*node));
      if (!met) continue;
      join(side == 0 ? *node : *met, side == 0 ? *met : *node);
      break;
    }
    return std::move(result_);
  }

 private:
  std::optional<std::uint32_t> extend(std::size_t side, std::uint32_t near, const Vec3& target) {
    const auto p = step_towards(near, target);
    if (!p) return std::nullopt;
    const std::uint32_t node = add_child(*p, near);
    index_[side].insert(*p, node);
    return node;
  }

  // The node of that tree that stands on `target`, if it could be grown there. The newest node is
  // always the nearest.
  std::optional<std::uint32_t> connect(std::size_t side, const Vec3& target) {
    std::uint32_t node = index_[side].nearest(target);
    while (point(node) != target) {
      if (!next_iteration()) return std::nullopt;
      const auto grown = extend(side, node, target);
      if (!grown) return std::nullopt;
      node = *grown;
    }
    return node;
  }

  void join(std::uint32_t of_start, std::uint32_t of_goal) {
    found_first(result_.tree.cost[of_start] + result_.tree.cost[of_goal]);
    result_.path = path_to_root(of_start);
    std::reverse(result_.path.begin(), result_.path.end());
    const Polyline rest = path_to_root(of_goal);
    result_.path.insert(result_.path.end(), rest.begin() + 1, rest.end());
  }

  PointIndex index_[2];
};

SamplingResult straight_line(const Vec3& from, const Vec3& to) {
  SamplingResult result;
  result.found = true;
  result.path = {from, to};
  result.first_length = (to - from).norm();
  result.tree = {{from, to}, {0, 0}, {0, 0}, {0, result.first_length}, {0, 0}};
  return result;
}

// With what was left open.
SamplingOptions fitted(const SamplingOptions& options, const geom::Aabb& free_bounds,
                       SamplingMethod method) {
  SamplingOptions out = options;
  if (!out.step) out.step = fitting_length(free_bounds, kStep);
  if (!out.radius) out.radius = fitting_length(free_bounds, kRadius);
  const bool ends_early = method == SamplingMethod::rrt || method == SamplingMethod::rrt_connect;
  const bool small = (free_bounds.max - free_bounds.min).maxCoeff() < kCity;
  if (!out.iterations) out.iterations = ends_early && small ? kSmallIterations : kIterations;
  return out;
}

}  // namespace

SamplingResult sample_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                           SamplingMethod method, const SamplingOptions& options) {
  check(options);
  if (!scene.free(from) || !scene.free(to)) return {};
  if (from == to || (options.straight_first && scene.free(from, to)))
    return straight_line(from, to);
  const SamplingOptions fitting = fitted(options, *scene.free_bounds(), method);
  switch (method) {
    case SamplingMethod::rrt:
      return Rrt(scene, from, to, fitting).run();
    case SamplingMethod::rrt_connect:
      return RrtConnect(scene, from, to, fitting).run();
    case SamplingMethod::rrt_star:
      return grow_rrt_star(scene, from, to, fitting, false);
    case SamplingMethod::informed_rrt_star:
      return grow_rrt_star(scene, from, to, fitting, true);
  }
  return {};
}

}  // namespace plan
