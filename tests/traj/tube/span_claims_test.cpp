#include "tube/span_claims.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "support/random_city.h"

namespace traj {
namespace {

using support::Random;
using Bounds = SpanClaims::Bounds;

// Of 25 coordinates some are larger numbers.
Bounds least_room() {
  Bounds out(25, 1e-8);
  std::fill(out.begin() + 13, out.begin() + 19, 2e-7);
  return out;
}

// A flight whose deviations are made larger by what was taken for them.
struct Loop {
  Bounds now;
  double kept;   // of a deviation, from period to period
  double added;  // to it
  double bend;   // of the square of what was taken

  Bounds next(const Bounds& taken) const {
    Bounds out(now.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = kept * now[i] + added + bend * taken[i] * taken[i];
    return out;
  }
};

// What was found in each period, and what was claimed of it.
struct Course {
  std::vector<Bounds> found, taken;
  std::vector<SpanBounds> spans;
};

Course course(Loop loop, int periods, const std::function<double(int)>& push) {
  Course out;
  SpanClaims claims(least_room(), 1);
  while (static_cast<int>(out.found.size()) < periods) {
    const Loop begin = loop;
    const std::size_t first = out.found.size();
    for (int k = 0; k < claims.periods() && static_cast<int>(out.found.size()) < periods; ++k) {
      out.found.push_back(loop.now);
      out.taken.push_back(claims.taken_for(loop.now));
      loop.added = push(static_cast<int>(out.found.size()));
      loop.now = loop.next(out.taken.back());
    }
    if (claims.settle()) continue;
    loop = begin;
    out.found.resize(first);
    out.taken.resize(first);
  }
  out.spans = claims.spans();
  return out;
}

int count(const std::vector<SpanBounds>& spans) {
  return std::accumulate(spans.begin(), spans.end(), 0,
                         [](int n, const SpanBounds& s) { return n + s.periods; });
}

TEST(SpanClaims, HaveRoomInEachPeriod) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    Loop loop{Bounds(25), random.uniform(0.8, 0.99), 0, random.uniform(0, 0.02)};
    for (double& d : loop.now) d = random.uniform(0, 1e-3);
    const Course flown =
        course(loop, 700, [&](int n) { return n / 100 % 2 ? 0.002 : random.uniform(0, 0.02); });
    ASSERT_EQ(count(flown.spans), 700) << seed;
    std::size_t n = 0;
    for (const SpanBounds& span : flown.spans) {
      ASSERT_GE(span.periods, 1);
      for (int k = 0; k < span.periods; ++k, ++n) {
        EXPECT_EQ(flown.taken[n], span.bounds) << seed << ": what was tried is what is claimed";
        for (std::size_t i = 0; i < span.bounds.size(); ++i)
          ASSERT_GE(span.bounds[i], 1.05 * flown.found[n][i]) << seed << " in period " << n;
      }
    }
  }
}

TEST(SpanClaims, GrowLongWhereNothingChanges) {
  Loop loop{Bounds(25), 0.9, 0.01, 0};
  loop.now.assign(25, 0.1);
  const Course flown = course(loop, 500, [](int) { return 0.01; });
  EXPECT_EQ(flown.spans[flown.spans.size() - 2].periods, 25);
  EXPECT_LE(flown.spans.size(), 30u);
  for (const double bound : flown.spans.back().bounds) EXPECT_LT(bound, 0.1 * 1.07);
}

// What swings as the loops take their turns is no reason for short spans.
TEST(SpanClaims, GrowLongWhereOnlyTheOrderOfLoopsSwings) {
  const auto shortest = [](std::size_t order) {
    SpanClaims claims(least_room(), order);
    for (int n = 0, span = 0; span < 40; ++span) {
      const int begin = n;
      do {
        n = begin;
        for (int k = claims.periods(); k > 0; --k, ++n)
          claims.taken_for(Bounds(25, n % 5 == 0 ? 6.0 : 1.0));
      } while (!claims.settle());
    }
    return claims.spans().back().periods;
  };
  EXPECT_EQ(shortest(5), 25);
  EXPECT_LE(shortest(1), 4);
}

// Of 1e-12 nothing smaller than what a checker adds for the simulator is claimed.
TEST(SpanClaims, AreNeverNearlyNothing) {
  const Course flown = course({Bounds(25), 0.5, 0, 0}, 10, [](int) { return 0; });
  for (const SpanBounds& span : flown.spans) {
    for (std::size_t i = 0; i < span.bounds.size(); ++i)
      EXPECT_GT(span.bounds[i], i >= 13 && i < 19 ? 1.5e-7 : 1.5e-9);
  }
}

TEST(SpanClaims, AreTriedForFewerPeriodsAfterTrouble) {
  SpanClaims claims(least_room(), 1);
  const Bounds found(25, 1.0);
  for (int k = 0; k < 10; ++k) {
    for (int n = claims.periods(); n > 0; --n) claims.taken_for(found);
    ASSERT_TRUE(claims.settle());
  }
  ASSERT_GT(claims.periods(), 8);
  while (claims.periods() > 1) {
    const int before = claims.periods();
    EXPECT_TRUE(claims.shorten());
    EXPECT_EQ(claims.periods(), before / 2);
  }
  EXPECT_FALSE(claims.shorten());
}

}  // namespace
}  // namespace traj
