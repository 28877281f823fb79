#include "traj/together/exact/exact_pair.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "geom/base/error.h"
#include "support/pair_case.h"
#include "traj/together/pair_check.h"

namespace traj {
namespace {

using support::Meeting;
using support::PairCase;

ExactPair check(const PairCase& c) {
  return check_pair_exactly(c.first(), c.second(), std::array{c.zone}, c.parked);
}

TEST(ExactPair, CallsNoTouchApart) {
  support::Random random(1);
  for (int i = 0; i < 600; ++i) {
    const auto how = static_cast<Meeting>(random.below(support::kMeetings));
    const double depth = random.below(2) ? 0 : random.stepped(0, 0.0625, 0x1p-31);
    EXPECT_FALSE(check(support::meeting(random, how, depth)).apart) << i;
  }
}

// Where the fast check leaves room for rounding.
TEST(ExactPair, AcceptsWhatIsAnyLengthBeyond) {
  support::Random random(2);
  for (int i = 0; i < 600; ++i) {
    const auto how = static_cast<Meeting>(random.below(support::kMeetings));
    EXPECT_TRUE(check(support::meeting(random, how, -0x1p-31)).apart) << i;
  }
}

TEST(ExactPair, HasASideForEachPieceAndPiecesForAllOfAStretch) {
  support::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const auto how = static_cast<Meeting>(random.below(support::kMeetings));
    const ExactPair proof = check(support::meeting(random, how, -1e-6));
    ASSERT_TRUE(proof.apart);
    for (const auto& covers : proof.stretches) {
      ASSERT_EQ(covers.size(), 1u);
      EXPECT_EQ(covers[0].pieces.size(), covers[0].sides.size());
      const double sum =
          std::accumulate(covers[0].pieces.begin(), covers[0].pieces.end(), 0.0,
                          [](double s, int depth) { return s + std::ldexp(1.0, -depth); });
      EXPECT_EQ(sum, 1);
    }
  }
}

TEST(ExactPair, TakesTheStepBetweenSegmentsAsFlown) {
  Trajectory a;
  a.segments.resize(2);
  a.segments[0].duration = a.segments[1].duration = 1;
  a.segments[0].point.fill({0, 0, 0});
  a.segments[1].point.fill({0, 3, 0});
  Trajectory b;
  b.segments.resize(1);
  b.segments[0].duration = 2;
  b.segments[0].point.fill({0, 1.5, 0});
  const TimedFlight flights[] = {{&a, 0, Vec3::Zero()}, {&b, 0, Vec3::Zero()}};
  EXPECT_FALSE(
      check_pair_exactly(flights[0], flights[1], std::array{cylinder(1, 1)}, Parked::pad).apart);
}

TEST(ExactPair, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Trajectory still;
  still.segments.resize(1);
  still.segments[0].duration = 1;
  still.segments[0].point.fill({0, 0, 0});
  const TimedFlight flight{&still, 0, Vec3::Zero()};
  const TimedFlight other{&still, nan, Vec3::Zero()};
  const TimedFlight wide{&still, 0, Vec3(0, nan, 0)};
  const Zone zone = cylinder(1, 1);
  Zone bad = zone;
  bad.reach[0] = nan;
  const auto check = [&](const TimedFlight& second, const Zone& keep) {
    check_pair_exactly(flight, second, std::array{keep}, Parked::pad);
  };
  EXPECT_NO_THROW(check(flight, zone));
  EXPECT_THROW(check(flight, bad), geom::InputError);
  EXPECT_THROW(check(other, zone), geom::InputError);
  EXPECT_THROW(check(wide, zone), geom::InputError);
}

}  // namespace
}  // namespace traj
