// The parts of skyway-bench that decide and count.

#include <gtest/gtest.h>

#include <stdexcept>

#include "bench/bounds.h"
#include "bench/command.h"
#include "bench/measure.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "geom/base/error.h"
#include "support/random_city.h"

namespace bench {
namespace {

using geom::Vec3;

// A wall from floor to ceiling in the middle; the vehicle is a point.
const geom::CollisionScene& scene() {
  static const geom::CollisionScene made = [] {
    geom::BoxMapSpec spec;
    spec.bounds = {{0, 0, 0}, {100, 100, 100}};
    return geom::CollisionScene(
        geom::BoxMap(spec, support::table_of({{{48, 20, 0}, {52, 100, 100}}})),
        {"point", Vec3::Zero()}, 0);
  }();
  return made;
}

const geom::PlanQuery kAcross{"q1", {10, 50, 10}, {90, 50, 10}, 120};

Verdict judged(const geom::Polyline& path, geom::PathStatus status = geom::PathStatus::found) {
  return judge(scene(), kAcross, {status, path, std::nullopt});
}

TEST(Judge, BelievesNoPath) {
  const Vec3 around1(47, 10, 10);
  const Vec3 around2(53, 10, 10);
  EXPECT_EQ(judged({kAcross.from, around1, around2, kAcross.to}), Verdict::found);
  EXPECT_EQ(judged({kAcross.from, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({kAcross.from, {48, 20, 10}, around2, kAcross.to}),
            Verdict::invalid);  // touches
  EXPECT_EQ(judged({kAcross.from, {47, -1, 10}, around2, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({kAcross.from, around1}), Verdict::invalid);
  EXPECT_EQ(judged({around1, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({}), Verdict::invalid);
}

TEST(Judge, TellsUnreachableFromFailed) {
  EXPECT_EQ(judged({}, geom::PathStatus::unreachable), Verdict::unreachable);
  EXPECT_EQ(judged({}, geom::PathStatus::stopped), Verdict::failed);
  EXPECT_EQ(judged({}, geom::PathStatus::start_blocked), Verdict::failed);
}

TEST(Judge, CountsABlockedOrOutsideEndAsFailedWhateverThePlannerCallsIt) {
  for (const geom::Vec3& end : {geom::Vec3(50, 50, 10), geom::Vec3(-9, 50, 10)}) {
    for (const geom::PlanQuery& query : {geom::PlanQuery{"a", end, {90, 50, 10}, {}, 0},
                                         geom::PlanQuery{"b", {90, 50, 10}, end, {}, 0}}) {
      ASSERT_FALSE(scene().free(end));
      for (const auto status : {geom::PathStatus::unreachable, geom::PathStatus::start_blocked,
                                geom::PathStatus::goal_outside, geom::PathStatus::stopped}) {
        EXPECT_EQ(judge(scene(), query, {status, {}, std::nullopt}), Verdict::failed);
      }
    }
  }
}

TEST(QuerySet, DrawsWhatWasAskedForAndTheSameEachTime) {
  RandomSpec spec;
  spec.ends = Ends::street_blocked;
  spec.length = {40, 60};
  QuerySet set(scene(), spec);
  QuerySet again(scene(), spec);
  again.at(150);
  for (std::size_t i = 0; i < 200; ++i) {
    const geom::PlanQuery& query = set.at(i);
    EXPECT_TRUE(scene().free(query.from) && scene().free(query.to));
    EXPECT_FALSE(scene().free(query.from, query.to));
    EXPECT_LE(std::max(query.from.z(), query.to.z()), 30);
    EXPECT_GE((query.to - query.from).norm(), 40 - 1e-9);
    EXPECT_LE((query.to - query.from).norm(), 60 + 1e-9);
    EXPECT_EQ(query.to, again.at(i).to);
  }
  EXPECT_GT(set.rejected().outside + set.rejected().blocked, 0u);
  EXPECT_GT(set.rejected().line_free, 0u);
}

TEST(QuerySet, GivesUp) {
  RandomSpec spec;
  spec.length = {200, 300};
  QuerySet set(scene(), spec);
  EXPECT_THROW(set.at(0), geom::InputError);
}

TEST(RunningMean, IsThatOfTheTextbook) {
  RunningMean mean;
  for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) mean.add(value);
  EXPECT_DOUBLE_EQ(mean.mean(), 5);
  EXPECT_DOUBLE_EQ(mean.standard_error(), std::sqrt(32.0 / 7 / 8));
}

Trial trial(Verdict verdict, double seconds, double length) {
  return {verdict, seconds, length, 1, std::nullopt, std::nullopt};
}

TEST(Compare, LooksAtTheQueriesThatBothRanAndBothFound) {
  bench::Run first;
  first.trials = {trial(Verdict::found, 1, 10), trial(Verdict::failed, 3, 0),
                  trial(Verdict::found, 2, 10)};
  bench::Run run;
  run.trials = {trial(Verdict::found, 4, 12), trial(Verdict::found, 4, 50)};
  const Comparison against = compare(run, first);
  EXPECT_DOUBLE_EQ(against.time, 2);
  EXPECT_DOUBLE_EQ(against.length.value(), 1.2);
  EXPECT_EQ(against.queries, 1u);
}

TEST(Measure, StopsAtTheLeastTrialsWhereTheRuleHolds) {
  QuerySet set(scene(), {});
  const Method method{[](const geom::PlanQuery&) {
                        return Answer{geom::PathStatus::unreachable, {}, {}};
                      },
                      {}};
  TrialRule rule;
  rule.least = 10;
  rule.within = 1;  // always: no standard error of times is more than their mean
  const bench::Run run = measure("none", method, scene(), set, rule, {});
  EXPECT_EQ(run.trials.size(), 10u);
  EXPECT_TRUE(run.converged.value());
  EXPECT_EQ(count(run, Verdict::unreachable), 10u);
  rule.converge = false;
  rule.most = 20;
  EXPECT_EQ(measure("none", method, scene(), set, rule, {}).trials.size(), 20u);
}

TEST(Measure, RunsAListWhole) {
  QuerySet list({kAcross, kAcross});
  const Method method{[](const geom::PlanQuery&) { return Answer{}; }, {}};
  const bench::Run run = measure("none", method, scene(), list, {}, {});
  EXPECT_EQ(run.trials.size(), 2u);
  EXPECT_FALSE(run.converged);
  EXPECT_EQ(run.trials[0].best_known, 120);
}

TEST(Command, GetsTheQueriesAndItsLinesAreRead) {
  const CommandOutput out = run_command("cat; echo; printf last; exit 3",
                                        to_json_lines({{"a", {1, 2, 3}, {4, 5, 6}}}), 1, {});
  ASSERT_EQ(out.lines.size(), 2u);
  EXPECT_EQ(out.lines[0], R"({"id":"a","from":[1,2,3],"to":[4,5,6]})");
  EXPECT_EQ(out.lines[1], "last");
  EXPECT_EQ(out.status, 3);
  EXPECT_GT(out.peak_rss, 0u);
  EXPECT_EQ(run_command("kill -9 $$", "", 0, {}).status, 128 + 9);
}

bench::Run run_of(std::vector<Trial> trials) {
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
}  // namespace bench
