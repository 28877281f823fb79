#include "plan/sampling/rrt.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "plan/lattice/fitting_length.h"
#include "rrt_connect.h"
#include "rrt_search.h"
#include "rrt_star.h"

namespace plan {
namespace {

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
  const bool small = (free_bounds.max - free_bounds.min).maxCoeff() < kCity;
  if (!out.iterations) out.iterations = !is_star(method) && small ? kSmallIterations : kIterations;
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
