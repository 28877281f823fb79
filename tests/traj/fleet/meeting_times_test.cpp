#include "fleet/meeting_times.h"

#include <gtest/gtest.h>

#include "traj/fleet/random_flights.h"

namespace traj {
namespace {

using testing::random_place;

StraightPiece piece(const Vec3& from, const Vec3& to, double begin, double end) {
  return {from, to - from, {0, 0}, begin, end};
}

TEST(MeetingTimes, OfOneThatStandsAndOneThatPasses) {
  // 10 m/s along x, past a point 3 m beside: within 5 m from x = -4 to 4, t from 9.6 to 10.4.
  const auto span = meeting_times(piece({-100, 0, 0}, {100, 0, 0}, 0, 20),
                                  piece({0, 3, 0}, {0, 3, 0}, 0, 0), cylinder(5, 1));
  ASSERT_TRUE(span);
  EXPECT_LE(span->low, 9.6);
  EXPECT_GE(span->high, 10.4);
  EXPECT_NEAR(span->low, 9.6, 0.01);
  EXPECT_NEAR(span->high, 10.4, 0.01);
}

TEST(MeetingTimes, OfAZoneThatGrowsWithTheFirst) {
  // A box of 1 m that stands at zero for 10 s and is 5 m larger at the end; a point at x = 4 stands
  // in it from second 6 on.
  const StraightPiece point = piece({4, 0, 0}, {4, 0, 0}, 0, 0);
  const Zone box{false, {1, 1, 1}};
  const auto span = meeting_times(piece({0, 0, 0}, {0, 0, 0}, 0, 10), point, box, {5, 0, 0});
  ASSERT_TRUE(span);
  EXPECT_LE(span->low, 6);
  EXPECT_NEAR(span->low, 6, 1e-6);
  EXPECT_NEAR(span->high, 10, 1e-6);
  EXPECT_FALSE(meeting_times(piece({0, 0, 0}, {0, 0, 0}, 0, 10), point, box, {2.9, 9, 9}));
}

TEST(MeetingTimes, NoneWhereTheLinesStayApart) {
  const StraightPiece a = piece({-100, 0, 0}, {100, 0, 0}, 0, 20);
  EXPECT_FALSE(meeting_times(a, piece({-100, 6, 0}, {100, 6, 0}, 0, 20), cylinder(5, 1)));
  EXPECT_FALSE(meeting_times(a, piece({0, 0, 2}, {0, 0, 2}, 0, 20), cylinder(5, 1)));
}

TEST(MeetingTimes, TouchingIsTooNear) {
  const StraightPiece a = piece({-100, 0, 0}, {100, 0, 0}, 0, 20);
  EXPECT_TRUE(meeting_times(a, piece({0, 5, 0}, {0, 5, 0}, 0, 20), cylinder(5, 1)));
  EXPECT_TRUE(meeting_times(a, piece({0, 0, 1}, {0, 0, 1}, 0, 20), cylinder(5, 1)));
  const Zone box{false, {5, 2, 1}};
  EXPECT_TRUE(meeting_times(a, piece({0, 2, 0}, {0, 2, 0}, 0, 20), box));
}

TEST(MeetingTimes, WithoutBeginWhereOneStandsBeforeItDeparts) {
  StraightPiece standing = piece({0, 0, 0}, {0, 0, 0}, 0, 0);
  standing.begin = -std::numeric_limits<double>::infinity();
  const auto span =
      meeting_times(standing, piece({-100, 0, 0}, {100, 0, 0}, 0, 20), cylinder(5, 1));
  ASSERT_TRUE(span);
  EXPECT_EQ(span->low, -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(span->high, -9.5, 0.01) << "t <= 0 and s >= 9.5";
  EXPECT_GE(span->high, -9.5);
}

TEST(MeetingTimes, HoldsEveryMeetingOfRandomPieces) {
  geom::SplitMix64 random(3);
  for (int k = 0; k < 2000; ++k) {
    const auto draw = [&] {
      const double begin = random.uniform(0, 100);
      StraightPiece p = piece(random_place(random, 30, 5), random_place(random, 30, 5), begin,
                              begin + random.uniform(0, 20));
      if (random.chance(0.1)) p.way = Vec3::Zero();
      p.off = {random.uniform(0, 0.5), random.uniform(0, 0.2)};
      return p;
    };
    const StraightPiece a = draw();
    const StraightPiece b = draw();
    const Zone zone =
        random.chance(0.5)
            ? cylinder(random.uniform(1, 10), random.uniform(0.5, 4))
            : Zone{false, random_place(random, 5, 3).cwiseAbs() + Vec3::Constant(0.1)};
    const auto span = meeting_times(a, b, zone);
    for (int i = 0; i <= 40; ++i) {
      for (int j = 0; j <= 40; ++j) {
        const Vec3 apart = a.from + i / 40.0 * a.way - b.from - j / 40.0 * b.way;
        if (share_of(zone, apart) > 1) continue;
        const double d =
            a.begin + i / 40.0 * (a.end - a.begin) - b.begin - j / 40.0 * (b.end - b.begin);
        ASSERT_TRUE(span && span->holds(d)) << "case " << k;
      }
    }
  }
}

}  // namespace
}  // namespace traj
