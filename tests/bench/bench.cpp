// Times of the parts, on one thread and warm, beside brute force.

#include <benchmark/benchmark.h>

#include <limits>

#include "geom/collision/collision.h"
#include "plan/lattice/astar.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/plan.h"
#include "solve/stop_and_go.h"
#include "support/bench_scene.h"
#include "traj/proof/check.h"
#include "traj/solve/min_snap.h"
#include "traj/solve/solve.h"

namespace {

using geom::Vec3;

using support::random_point;
using support::scene;
using support::segments;

void BruteForceSegment(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = segments()[i++ % segments().size()];
    benchmark::DoNotOptimize(support::brute_force(a, b));
  }
}
BENCHMARK(BruteForceSegment);

void SceneSegment(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = segments()[i++ % segments().size()];
    benchmark::DoNotOptimize(scene().hits(a, b));
  }
}
BENCHMARK(SceneSegment);

void SceneNearest(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene().nearest(segments()[i++ % segments().size()].first,
                                             std::numeric_limits<double>::infinity()));
  }
}
BENCHMARK(SceneNearest);

void LatticeBuild(benchmark::State& state) {
  const plan::LatticeSpec spec{static_cast<double>(state.range(0)),
                               static_cast<plan::Connectivity>(state.range(1)),
                               scene().map().spec().bounds.min};
  for (auto _ : state) benchmark::DoNotOptimize(plan::build_lattice(scene(), spec, {2, {}}));
}
BENCHMARK(LatticeBuild)
    ->Args({25, 6})
    ->Args({25, 26})
    ->Args({10, 26})
    ->Args({5, 6})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// 200 node pairs 600 to 700 m apart that are joined.
void AstarSixConnected(benchmark::State& state) {
  const plan::Lattice lattice =
      plan::build_lattice(scene(),
                          {static_cast<double>(state.range(0)), plan::Connectivity::six,
                           scene().map().spec().bounds.min},
                          {2, {}});
  plan::AstarSearch search(lattice);
  support::Random random(2);
  std::vector<std::pair<plan::Terminal, plan::Terminal>> queries;
  while (queries.size() < 200) {
    const plan::Terminal a{static_cast<std::size_t>(random.below(static_cast<int>(lattice.size()))),
                           0};
    const plan::Terminal b{static_cast<std::size_t>(random.below(static_cast<int>(lattice.size()))),
                           0};
    const double far = (lattice.position(a.node) - lattice.position(b.node)).norm();
    if (!lattice.free(a.node) || !lattice.free(b.node) || far < 600 || far > 700) continue;
    if (search.search({&a, 1}, {&b, 1}).found) queries.push_back({a, b});
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = queries[i++ % queries.size()];
    benchmark::DoNotOptimize(search.search({&a, 1}, {&b, 1}).cost);
  }
}
BENCHMARK(AstarSixConnected)->Arg(25)->Arg(5)->Unit(benchmark::kMicrosecond);

void MinSnap(benchmark::State& state) {
  support::Random random(3);
  std::vector<Vec3> points;
  std::vector<double> times;
  for (int i = 0; i < state.range(0); ++i) {
    points.push_back({10.0 * i, random.uniform(-5, 5), random.uniform(20, 40)});
    if (i) times.push_back(random.uniform(1, 3));
  }
  for (auto _ : state) benchmark::DoNotOptimize(traj::min_snap(points, times));
}
BENCHMARK(MinSnap)->Arg(10)->Arg(1000)->Unit(benchmark::kMicrosecond);

// The proof of an optimised trajectory of at least 50 segments through the city.
void CheckTrajectory(benchmark::State& state) {
  plan::Planner planner(scene(), nullptr);
  support::Random random(4);
  traj::SolveResult solved;
  const traj::Limits limits{{traj::Limit::speed, 8}, {traj::Limit::acceleration, 6}};
  while (solved.trajectory.segments.size() < 50) {
    const plan::PlanResult path = planner.plan(random_point(random), random_point(random), {});
    if (path.status != geom::PathStatus::found || path.path.size() < 8) continue;
    solved = traj::solve(scene(), path.path, {limits, traj::Solver::automatic, 1e-3, 200});
  }
  for (auto _ : state) {
    const traj::CheckResult result = traj::check(scene(), solved.trajectory, limits);
    if (!result.ok) state.SkipWithError("the trajectory is not proved");
  }
  state.counters["segments"] = static_cast<double>(solved.trajectory.segments.size());
}
BENCHMARK(CheckTrajectory)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
