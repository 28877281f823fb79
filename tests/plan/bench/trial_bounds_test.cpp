#include "plan/bench/trial_bounds.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "plan/bench/trial_report.h"
#include "support/walled_scene.h"

namespace plan::bench {
namespace {

using geom::Vec3;
using support::kAcross;

const geom::CollisionScene& scene() { return support::walled_scene(); }

Run run_of(std::vector<Trial> trials) {
  bench::Run run;
  run.trials = std::move(trials);
  return run;
}

TEST(Bounds, AreNearTheShortestPathThatWasFound) {
  const Vec3 around1(48, 20, 10);
  const Vec3 around2(52, 20, 10);
  const double best = geom::length({kAcross.from, around1, around2, kAcross.to});
  Trial good;
  good.verdict = Verdict::found;
  good.length = best + 0.01;
  Trial long_way = good;
  long_way.length = 2 * best;
  std::vector<bench::Run> runs = {run_of({long_way, Trial{}}), run_of({good})};
  QuerySet queries({kAcross, kAcross});
  add_bounds(runs, scene(), queries, 1e-3, {});
  for (const bench::Run& run : runs) {
    ASSERT_TRUE(run.trials[0].bound);
    EXPECT_TRUE(run.trials[0].bound->closed);
    EXPECT_LE(run.trials[0].bound->length, best);
    EXPECT_GE(run.trials[0].bound->length, 0.998 * best);
  }
  EXPECT_FALSE(runs[0].trials[1].bound);  // no path
  const auto of = report(runs[0], runs[0])["length_over_bound"];
  EXPECT_EQ(of["paths"], 1);
  EXPECT_EQ(of["closed"], 1);
  EXPECT_NEAR(of["max"].get<double>(), 2, 0.01);
}

TEST(Bounds, AreNeverAboveAPath) {
  Trial lie;
  lie.verdict = Verdict::found;
  lie.length = 1;
  std::vector<bench::Run> runs = {run_of({lie})};
  QuerySet queries({kAcross});
  EXPECT_THROW(add_bounds(runs, scene(), queries, 1e-3, {}), std::logic_error);
}

}  // namespace
}  // namespace plan::bench
