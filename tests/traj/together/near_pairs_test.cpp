#include "traj/together/near_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "support/pair_case.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::Meeting;

TEST(NearPairs, LeaveOutNoneThatTouch) {
  support::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto how = static_cast<Meeting>(random.below(support::kMeetings));
    const support::PairCase c = support::meeting(random, how, random.below(2) ? 0 : 0.03125);
    const TimedFlight flights[] = {c.first(), c.second()};
    for (const double step : {0.5, 4.0, 1e3}) {
      EXPECT_EQ(near_pairs(flights, {c.zone, {}}, c.parked, {}, step).size(), 1u) << i;
    }
  }
}

TEST(NearPairs, LeaveOutThoseThatAreFarApartInSpaceOrTime) {
  support::Random random(2);
  Trajectory here{{support::random_segment(random, 5)}};
  Trajectory there = here;
  for (Vec3& p : there.segments[0].point) p.x() += 1000;
  const Spacing spacing{cylinder(10, 5), {}};
  const auto near = [&](const Trajectory& other, double start, Parked parked) {
    const TimedFlight flights[] = {{&here, 0, Vec3::Zero()}, {&other, start, Vec3::Zero()}};
    return !near_pairs(flights, spacing, parked).empty();
  };
  EXPECT_TRUE(near(here, 3, Parked::gone));
  EXPECT_TRUE(near(here, 5, Parked::gone));
  EXPECT_FALSE(near(here, 5.001, Parked::gone));
  EXPECT_TRUE(near(here, 1e6, Parked::pad));
  EXPECT_FALSE(near(there, 0, Parked::pad));
}

TEST(NearPairs, AreNoneOfNoFlights) { EXPECT_TRUE(near_pairs({}, {}, Parked::pad).empty()); }

TEST(NearPairs, RefuseFlightsAndZonesThatNobodyCanJudge) {
  const double nan = std::nan("");
  const Trajectory line = testing::straight({0, 0, 0}, {80, 0, 0}, 8);
  const TimedFlight good{&line, 0, Vec3::Zero()};
  const TimedFlight late[] = {good, {&line, nan, Vec3::Zero()}};
  const TimedFlight wide[] = {good, {&line, 0, Vec3(nan, 0, 0)}};
  const TimedFlight fine[] = {good, good};
  EXPECT_THROW(near_pairs(late, {}, Parked::gone), geom::InputError);
  EXPECT_THROW(near_pairs(wide, {}, Parked::gone), geom::InputError);
  EXPECT_THROW(near_pairs(fine, {cylinder(nan, nan), {}}, Parked::gone), geom::InputError);
}

}  // namespace
}  // namespace traj
