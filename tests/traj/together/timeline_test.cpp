#include "together/timeline.h"

#include <gtest/gtest.h>

#include "support/pair_case.h"

namespace traj {
namespace {

using support::Random;
using support::random_segment;

Trajectory chain(Random& random, int segments) {
  Trajectory t;
  for (int i = 0; i < segments; ++i) {
    t.segments.push_back(random_segment(random, random.uniform(0.1, 3)));
    if (i > 0) t.segments[i].point.front() = t.segments[i - 1].point.back();
  }
  return t;
}

TEST(Timeline, KnowsItsJointsExactly) {
  Random random(3);
  const Trajectory t = chain(random, 3);
  const Timeline line({&t, 0.1, Vec3::Zero()});
  ASSERT_EQ(line.joint.size(), 4u);
  EXPECT_TRUE(line.joint[0] == ticks_of(0.1));
  EXPECT_TRUE(line.joint[3] - line.joint[2] == ticks_of(t.segments[2].duration));
  EXPECT_EQ(line.gap, 0);
}

TEST(Timeline, KnowsByHowMuchSegmentsMissEachOther) {
  Random random(3);
  Trajectory t = chain(random, 2);
  t.segments[1].point.front().y() += 1e-3;
  EXPECT_GE(Timeline({&t, 0, Vec3::Zero()}).gap, 1e-3 * (1 - 1e-9));
}

TEST(Stretches, LieSideBySideOverAllTime) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Trajectory a = chain(random, 1 + random.below(4));
    const Trajectory b = chain(random, 1 + random.below(4));
    const Timeline one({&a, random.uniform(0, 8), Vec3::Zero()});
    const Timeline other({&b, random.uniform(0, 8), Vec3::Zero()});
    const auto pads = stretches(one, other, Parked::pad);
    EXPECT_FALSE(pads.front().begin);
    EXPECT_FALSE(pads.back().end);
    for (std::size_t k = 0; k + 1 < pads.size(); ++k) {
      EXPECT_TRUE(*pads[k].end == *pads[k + 1].begin);
    }
    for (const CommonStretch& s : stretches(one, other, Parked::gone)) {
      EXPECT_TRUE(s.segment && s.other);
      EXPECT_TRUE(*s.begin >= one.joint[*s.segment] && *s.end <= one.joint[*s.segment + 1]);
      EXPECT_TRUE(*s.begin >= other.joint[*s.other] && *s.end <= other.joint[*s.other + 1]);
    }
  }
}

TEST(Stretches, AreAnInstantWhereOneLeavesAsTheOtherArrives) {
  Random random(5);
  const Trajectory t = chain(random, 1);
  const double end = t.segments[0].duration;
  const auto met =
      stretches(Timeline({&t, 0, Vec3::Zero()}), Timeline({&t, end, Vec3::Zero()}), Parked::gone);
  ASSERT_EQ(met.size(), 1u);
  EXPECT_TRUE(*met[0].begin == *met[0].end);
  EXPECT_TRUE(met[0].first_over && !met[0].other_over);
  EXPECT_TRUE(stretches(Timeline({&t, 0, Vec3::Zero()}),
                        Timeline({&t, std::nextafter(end, 99.0), Vec3::Zero()}), Parked::gone)
                  .empty());
}

TEST(RelativeCurve, IsThePositionLessTheOthers) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Trajectory a = chain(random, 2);
    const Trajectory b = chain(random, 2);
    const double start_a = random.uniform(0, 4);
    const double start_b = random.uniform(0, 4);
    const Timeline one({&a, start_a, Vec3::Zero()});
    const Timeline other({&b, start_b, Vec3::Zero()});
    for (const CommonStretch& s : stretches(one, other, Parked::pad)) {
      if (!s.begin || !s.end) continue;
      const RelativeCurve curve = relative_curve(one, other, s);
      const double from = seconds_of(*s.begin);
      const double until = seconds_of(*s.end);
      for (const double share : {0.0, 0.3, 1.0}) {
        const double t = from + share * (until - from);
        const Vec3 expected = evaluate(a, t - start_a).position - evaluate(b, t - start_b).position;
        const Vec3 found = evaluate({1, curve.q, {}}, share).position;
        EXPECT_LT((found - expected).norm(), 1e-9) << i;
      }
    }
  }
}

}  // namespace
}  // namespace traj
