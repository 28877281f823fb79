#include "traj/together/nearest_approach.h"

#include <gtest/gtest.h>

#include "support/pair_case.h"
#include "support/random_city.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::straight;

TEST(NearestApproaches, AreThoseOfStraightWays) {
  const Trajectory a = straight({-10, 0, 5}, {10, 0, 5});
  const Trajectory b = straight({0, -10, 8}, {0, 10, 8});
  const TimedFlight flights[] = {{&a, 100, Vec3::Zero()}, {&b, 100, Vec3::Zero()}};
  const auto found = nearest_approaches(flights, 50.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].flights, FlightPair(0, 1));
  EXPECT_NEAR(found[0].distance, 3, 1e-3);
  EXPECT_NEAR(found[0].time, 105, 0.1);
  EXPECT_NEAR((found[0].place - Vec3(0, 0, 5)).norm(), 0, 0.2);
  EXPECT_NEAR((found[0].place - found[0].other).norm(), found[0].distance, 1e-9);
}

TEST(NearestApproaches, CountOnlyWhileBothFly) {
  const Trajectory a = straight({-10, 0, 5}, {10, 0, 5});
  const TimedFlight late[] = {{&a, 0, Vec3::Zero()}, {&a, 10.5, Vec3::Zero()}};
  EXPECT_TRUE(nearest_approaches(late, 1000.0).empty());
  const TimedFlight behind[] = {{&a, 0, Vec3::Zero()}, {&a, 5, Vec3::Zero()}};
  const auto found = nearest_approaches(behind, 1000.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].distance, 10, 1e-3);
}

TEST(NearestApproaches, AreWithinWhatWasAsked) {
  const Trajectory a = straight({0, 0, 5}, {100, 0, 5});
  const Trajectory b = straight({0, 20, 5}, {100, 20, 5});
  const TimedFlight flights[] = {{&a, 0, Vec3::Zero()}, {&b, 0, Vec3::Zero()}};
  EXPECT_TRUE(nearest_approaches(flights, 19.9).empty());
  EXPECT_EQ(nearest_approaches(flights, 20.1).size(), 1u);
}

std::vector<Trajectory> random_flights(support::Random& random, std::size_t count) {
  std::vector<Trajectory> out(count);
  for (Trajectory& t : out) {
    for (int i = 0; i < 3; ++i) {
      Segment s = support::random_segment(random, random.uniform(1, 6));
      if (i > 0) {
        const Vec3 shift = t.segments.back().point.back() - s.point.front();
        for (Vec3& p : s.point) p += shift;
      }
      t.segments.push_back(s);
    }
  }
  return out;
}

// Against samples, which can only be farther apart than the nearest is.
TEST(NearestApproachesProperty, AreNoFartherThanSamplesAndAsNearAsTheyComeThere) {
  support::Random random(7);
  const std::vector<Trajectory> ways = random_flights(random, 12);
  std::vector<TimedFlight> flights;
  for (const Trajectory& way : ways) flights.push_back({&way, random.uniform(0, 8), Vec3::Zero()});
  const auto found = nearest_approaches(flights, 1e4);
  for (const Approach& approach : found) {
    const TimedFlight& a = flights[approach.flights.first];
    const TimedFlight& b = flights[approach.flights.second];
    double least = 1e300;
    const double begin = std::max(a.start, b.start);
    const double end =
        std::min(a.start + duration(*a.trajectory), b.start + duration(*b.trajectory));
    for (int i = 0; i <= 4000; ++i) {
      const double t = begin + (end - begin) * i / 4000;
      least = std::min(least, (evaluate(*a.trajectory, t - a.start).position -
                               evaluate(*b.trajectory, t - b.start).position)
                                  .norm());
    }
    SCOPED_TRACE(::testing::Message()
                 << "seed 7, " << approach.flights.first << " and " << approach.flights.second);
    EXPECT_LE(approach.distance, least + 1.001e-3);
    EXPECT_GE(approach.time, begin - 1e-9);
    EXPECT_LE(approach.time, end + 1e-9);
    EXPECT_NEAR((evaluate(*b.trajectory, approach.time - b.start).position - approach.other).norm(),
                0, 1e-6);
  }
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_LE(found[i - 1].distance, found[i].distance);
  }
}

TEST(NearestApproaches, AreTheSameForAnyNumberOfThreads) {
  support::Random random(8);
  const std::vector<Trajectory> ways = random_flights(random, 30);
  std::vector<TimedFlight> flights;
  for (const Trajectory& way : ways) flights.push_back({&way, random.uniform(0, 8), Vec3::Zero()});
  const auto one = nearest_approaches(flights, 1e4);
  geom::Execution seven;
  seven.threads = 7;
  const auto many = nearest_approaches(flights, 1e4, seven);
  ASSERT_EQ(one.size(), many.size());
  ASSERT_FALSE(one.empty());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].flights, many[i].flights);
    EXPECT_EQ(one[i].distance, many[i].distance);
    EXPECT_EQ(one[i].time, many[i].time);
  }
}

TEST(NearestApproaches, LookAsFarAsSomePairsAre) {
  std::vector<Trajectory> ways;
  for (int i = 0; i < 10; ++i) ways.push_back(straight({0, 15.0 * i, 5}, {100, 15.0 * i, 5}));
  std::vector<TimedFlight> flights;
  for (const Trajectory& way : ways) flights.push_back({&way, 0, Vec3::Zero()});
  const Approaches few = nearest_approaches(flights, 9, 1000);
  EXPECT_EQ(few.within, 20);
  EXPECT_EQ(few.list.size(), 9u);
  const Approaches bounded = nearest_approaches(flights, 1000, 30.5);
  EXPECT_EQ(bounded.within, 30.5);
  EXPECT_EQ(bounded.list.size(), 17u);
  EXPECT_TRUE(nearest_approaches({}, 1, 10).list.empty());
}

}  // namespace
}  // namespace traj
