#include "traj/flight/tracking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace traj {
namespace {

// Of 1 s: an error that grows by 1 mm a sample to 100 mm, then shrinks by 2 mm a sample.
TEST(Tracking, IsOfTheErrorsUpToTheEndAndSettlesAfterIt) {
  Flight flight;
  for (int k = 0; k <= 100; ++k) flight.error.push_back(0.001 * k);
  for (int k = 1; k <= 50; ++k) flight.error.push_back(0.1 - 0.002 * k);
  flight.final_distance = 0.003;
  const Tracking t = tracking(flight, 1);
  EXPECT_NEAR(t.mean, 0.05, 1e-12);
  EXPECT_NEAR(t.rms, 0.001 * std::sqrt(100 * 201 / 6.0), 1e-12) << "the sum of squares of 1 to 100";
  EXPECT_NEAR(t.p99, 0.099, 1e-12) << "rank 100 of 101";
  EXPECT_NEAR(t.largest, 0.1, 1e-12);
  EXPECT_EQ(t.largest_time, 1);
  EXPECT_NEAR(t.arrival, 0.1, 1e-12);
  EXPECT_EQ(t.final_distance, 0.003);
  ASSERT_TRUE(t.settling);
  EXPECT_NEAR(*t.settling, 0.26, 0.0101) << "0.05 m after 25 samples";
}

TEST(Tracking, SettlesAtOnceOrNever) {
  Flight flight;
  flight.error.assign(201, 0.01);
  EXPECT_EQ(tracking(flight, 1).settling, 0);
  flight.error.back() = 0.06;
  EXPECT_FALSE(tracking(flight, 1).settling);
}

}  // namespace
}  // namespace traj
