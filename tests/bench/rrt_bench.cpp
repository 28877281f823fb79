// Times the sampling planners on the city, between random street-level ends that do not see each
// other, then with the goals walled in, so that every iteration is used. Usage: rrt_bench [queries]
// [iterations]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "plan/sampling/rrt.h"
#include "support/bench_scene.h"

namespace {

using geom::Vec3;

std::vector<std::pair<Vec3, Vec3>> blocked_queries(std::size_t count) {
  support::Random random(7);
  std::vector<std::pair<Vec3, Vec3>> out;
  while (out.size() < count) {
    Vec3 from = support::random_point(random);
    Vec3 to = support::random_point(random);
    from.z() = random.uniform(2, 30);
    to.z() = random.uniform(2, 30);
    const geom::CollisionScene& scene = support::scene();
    if (scene.free(from) && scene.free(to) && !scene.free(from, to)) out.push_back({from, to});
  }
  return out;
}

// The city with a closed shell around the goal of each query.
geom::CollisionScene walled_in(const std::vector<std::pair<Vec3, Vec3>>& queries) {
  const geom::BoxMap& map = support::scene().map();
  std::vector<geom::Aabb> boxes(map.boxes().begin(), map.boxes().end());
  for (const auto& ends : queries) {
    for (int k = 0; k < 3; ++k) {
      for (const double side : {-2.0, 2.0}) {
        const Vec3 middle = ends.second + side * Vec3::Unit(k);
        const Vec3 half = Vec3::Constant(2) - 1.9 * Vec3::Unit(k);
        boxes.push_back({middle - half, middle + half});
      }
    }
  }
  return {geom::BoxMap(map.spec(), support::table_of(std::move(boxes))), {"box", {1, 1, 1}}, 0};
}

struct Run {
  double milliseconds;
  plan::SamplingResult result;
};

Run run(const geom::CollisionScene& scene, plan::SamplingMethod method,
        const std::pair<Vec3, Vec3>& ends, const plan::SamplingOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  plan::SamplingResult result = plan::sample_path(scene, ends.first, ends.second, method, options);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  return {time.count(), std::move(result)};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

void report(const geom::CollisionScene& scene, plan::SamplingMethod method,
            const std::vector<std::pair<Vec3, Vec3>>& queries,
            const plan::SamplingOptions& options) {
  std::vector<double> times, ratios, nodes;
  for (const auto& ends : queries) {
    const auto [milliseconds, result] = run(scene, method, ends, options);
    times.push_back(milliseconds);
    nodes.push_back(static_cast<double>(result.tree.points.size()));
    if (result.found) {
      ratios.push_back(geom::length(result.path) / (ends.second - ends.first).norm());
    }
  }
  fmt::print(
      "{:18} found {:3}/{}  ms: median {:8.2f} max {:8.2f}  nodes: {:6.0f}  length: {:.3f}\n",
      plan::name(method), ratios.size(), queries.size(), median(times),
      *std::max_element(times.begin(), times.end()), median(nodes), median(ratios));
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20;
  plan::SamplingOptions options;
  if (argc > 2) options.iterations = std::strtoull(argv[2], nullptr, 10);
  const auto queries = blocked_queries(std::max<std::size_t>(count, 1));
  const geom::CollisionScene walled = walled_in(queries);
  for (const geom::CollisionScene* scene : {&support::scene(), &walled}) {
    for (const auto method :
         {plan::SamplingMethod::rrt, plan::SamplingMethod::rrt_connect,
          plan::SamplingMethod::rrt_star, plan::SamplingMethod::informed_rrt_star}) {
      report(*scene, method, queries, options);
    }
  }
  return 0;
}
