#include "traj/figure/tracking.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace {

TEST(Tracking, StatesTheErrors) {
  traj::FlightLog log{"f", "", {}};
  for (int i = 0; i < 4; ++i) {
    traj::FlightSample s;
    s.time = i;
    s.setpoint_position = {i == 2 ? 4.0 : 0.0, 0, 0};
    log.samples.push_back(s);
  }
  const std::string svg = traj::figure::tracking(log);
  EXPECT_TRUE(support::says(svg, "f: 3.00 s flown, tracking error 2 m root mean square"));
  EXPECT_TRUE(support::says(svg, "largest 4 m"));
  log.samples.resize(1);  // one row has no time to show
  EXPECT_FALSE(support::says(traj::figure::tracking(log), "nan"));
}

}  // namespace
