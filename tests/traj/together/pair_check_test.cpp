#include "traj/together/pair_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "support/pair_case.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::Meeting;
using support::PairCase;
using testing::straight;

PairResult check(const PairCase& c) {
  return check_pair(c.first(), c.second(), std::array{c.zone}, c.parked);
}

TEST(PairCheck, IsTheSameTheOtherWayRound) {
  support::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto how = static_cast<Meeting>(random.below(support::kMeetings));
    PairCase c = support::meeting(random, how, random.stepped(-0.0625, 0.0625, 0x1p-10));
    const bool apart = check(c).apart;
    std::swap(c.a, c.b);
    std::swap(c.start_a, c.start_b);
    EXPECT_EQ(check(c).apart, apart) << i;
  }
}

// Two that cross at right angles, at one height, both in the middle at 4 s.
TEST(PairCheck, SaysWhenWhereAndByHowMuch) {
  const Trajectory a = straight({0, 0, 30}, {80, 0, 30}, 8);
  const Trajectory b = straight({40, -40, 33}, {40, 40, 33}, 8);
  const auto result = check_pair({&a, 100, Vec3::Zero()}, {&b, 100, Vec3::Zero()},
                                 std::array{cylinder(10, 4)}, Parked::gone);
  EXPECT_FALSE(result.apart);
  EXPECT_FALSE(result.undecided);
  EXPECT_NEAR(result.share, 0.75, 1e-6);
  EXPECT_NEAR(result.depth, 1, 1e-6);
  ASSERT_EQ(result.when.size(), 1u);
  const double half = 10 / (10 * std::sqrt(2.0));
  EXPECT_NEAR(result.when[0].begin, 104 - half, 2e-3);
  EXPECT_NEAR(result.when[0].end, 104 + half, 2e-3);
  EXPECT_LE(result.when[0].begin, 104 - half);
  EXPECT_GE(result.when[0].end, 104 + half);
  EXPECT_NEAR(result.place.x(), 40, 8);
  EXPECT_NEAR((result.place - result.other).z(), -3, 1e-9);
  EXPECT_TRUE(check_pair({&a, 100, Vec3::Zero()}, {&b, 102, Vec3::Zero()},
                         std::array{cylinder(10, 4)}, Parked::gone)
                  .apart);
}

TEST(PairCheck, LooksBeforeDepartureAndAfterArrivalOnPads) {
  const Trajectory a = straight({0, 0, 0}, {80, 0, 0}, 8);
  const Trajectory b = straight({80, 5, 0}, {80, 200, 0}, 8);
  const std::array zone{cylinder(10, 4)};
  EXPECT_TRUE(check_pair({&a, 0, Vec3::Zero()}, {&b, 9, Vec3::Zero()}, zone, Parked::gone).apart);
  const auto late = check_pair({&a, 0, Vec3::Zero()}, {&b, 9, Vec3::Zero()}, zone, Parked::pad);
  EXPECT_FALSE(late.apart);
  EXPECT_TRUE(std::isfinite(late.when.front().begin) && std::isfinite(late.when.back().end));
  const auto early = check_pair({&b, 9, Vec3::Zero()}, {&a, 0, Vec3::Zero()}, zone, Parked::pad);
  EXPECT_FALSE(early.apart);
  const auto beside = check_pair({&b, 0, Vec3::Zero()}, {&b, 5, Vec3::Zero()}, zone, Parked::pad);
  ASSERT_FALSE(beside.apart);
  EXPECT_TRUE(std::isinf(beside.when.front().begin) && std::isinf(beside.when.back().end));
  EXPECT_EQ(beside.share, 0);
}

TEST(PairCheck, CountsBothZones) {
  const Trajectory a = straight({0, 0, 30}, {80, 0, 30}, 8);
  const Trajectory b = straight({0, 1, 22}, {80, 1, 22}, 8);
  EXPECT_TRUE(check_pair({&a, 0, Vec3::Zero()}, {&b, 0, Vec3::Zero()}, std::array{cylinder(10, 4)},
                         Parked::pad)
                  .apart);
  const auto below = check_pair({&a, 0, Vec3::Zero()}, {&b, 0, Vec3::Zero()},
                                std::array{cylinder(10, 4), cylinder(2, 12)}, Parked::pad);
  EXPECT_FALSE(below.apart);
  EXPECT_EQ(below.zone, 1u);
}

TEST(PairCheck, TakesTheStepBetweenSegmentsAsFlown) {
  Trajectory a = straight({0, 0, 0}, {80, 0, 0}, 8);
  a.segments.push_back(straight({80, 3, 0}, {160, 3, 0}, 8).segments[0]);
  const Trajectory b = straight({80, 1.5, 0}, {80, 1.5, 0}, 16);
  const std::array zone{cylinder(1, 1)};
  EXPECT_FALSE(check_pair({&a, 0, Vec3::Zero()}, {&b, 0, Vec3::Zero()}, zone, Parked::pad).apart);
}

// A metre of motion, ten million metres from the origin, and a day after the epoch.
TEST(PairCheck, IsNoCoarserFarFromTheOrigin) {
  const Vec3 far(1e7, -1e7, 1000);
  const Trajectory a = straight(far, far + Vec3(1, 0, 0), 1);
  const Trajectory b = straight(far + Vec3(0, 4 + 0x1p-28, 0), far + Vec3(1, 4 + 0x1p-28, 0), 1);
  EXPECT_TRUE(check_pair({&a, 86400.1, Vec3::Zero()}, {&b, 86400.1, Vec3::Zero()},
                         std::array{cylinder(4, 1)}, Parked::pad)
                  .apart);
  EXPECT_FALSE(check_pair({&a, 86400.1, Vec3::Zero()}, {&b, 86400.1, Vec3::Zero()},
                          std::array{cylinder(4 + 0x1p-28, 1)}, Parked::pad)
                   .apart);
}

TEST(PairCheck, RefusesFlightsAndZonesThatNobodyCanJudge) {
  const double nan = std::nan("");
  const Trajectory line = straight({0, 0, 0}, {80, 0, 0}, 8);
  Trajectory broken = line;
  broken.segments[0].point[3].y() = nan;
  const TimedFlight good{&line, 0, Vec3::Zero()};
  for (const TimedFlight& wrong :
       {TimedFlight{&line, nan, Vec3::Zero()}, TimedFlight{&line, 0, Vec3(0, nan, 0)},
        TimedFlight{&line, 0, Vec3(-1, 0, 0)}, TimedFlight{&broken, 0, Vec3::Zero()}}) {
    EXPECT_THROW(check_pair(good, wrong, std::array{cylinder(1, 1)}, Parked::gone),
                 geom::InputError);
  }
  for (const Zone& wrong : {cylinder(nan, 1), cylinder(-1, 1), cylinder(1, INFINITY)}) {
    EXPECT_THROW(check_pair(good, good, std::array{wrong}, Parked::gone), geom::InputError);
  }
}

}  // namespace
}  // namespace traj
