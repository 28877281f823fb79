// Minimum snap three ways: the closed form, and the textbook equations by dense and by sparse LU.
// Each time includes setting the equations up; the argument is the number of segments.

#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <vector>

#include "curve/bernstein.h"
#include "support/bench_scene.h"
#include "support/min_snap_equations.h"
#include "traj/solve/min_snap.h"

namespace {

struct Problem {
  std::vector<geom::Vec3> points;
  std::vector<double> times;
};

Problem problem(std::int64_t segments) {
  support::Random random(3);
  Problem p;
  for (std::int64_t i = 0; i <= segments; ++i) {
    p.points.push_back(
        {10 * static_cast<double>(i), random.uniform(-5, 5), random.uniform(20, 40)});
    if (i > 0) p.times.push_back(random.uniform(1, 3));
  }
  return p;
}

void run(benchmark::State& state, traj::Trajectory (*solve)(const Problem&)) {
  const Problem p = problem(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(solve(p));
  state.counters["cost"] = traj::snap_cost(solve(p));
}

void ClosedForm(benchmark::State& state) {
  run(state, [](const Problem& p) { return traj::min_snap(p.points, p.times); });
}
BENCHMARK(ClosedForm)->Arg(10)->Arg(100)->Arg(999)->Arg(10000)->Unit(benchmark::kMicrosecond);

void SparseLu(benchmark::State& state) {
  run(state, [](const Problem& p) {
    const auto equations = support::min_snap_equations(p.points, p.times);
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(equations.sparse());
    return support::trajectory_of(lu.solve(equations.right), p.times);
  });
}
BENCHMARK(SparseLu)->Arg(10)->Arg(100)->Arg(999)->Arg(10000)->Unit(benchmark::kMicrosecond);

// 8 n unknowns: 64 million entries for 1,000 segments, and minutes; so to 300 by default.
void DenseLu(benchmark::State& state) {
  run(state, [](const Problem& p) {
    const auto equations = support::min_snap_equations(p.points, p.times);
    return support::trajectory_of(equations.dense().partialPivLu().solve(equations.right), p.times);
  });
}
BENCHMARK(DenseLu)->Arg(10)->Arg(100)->Arg(300)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
