#include "traj/figure/tracking.h"

#include <gtest/gtest.h>

namespace {

bool holds(const std::string& svg, const std::string& words) {
  return svg.find(words) != std::string::npos;
}

TEST(Tracking, StatesTheErrors) {
  traj::FlightLog log{"f", "", {}};
  for (int i = 0; i < 4; ++i) {
    traj::FlightSample s;
    s.time = i;
    s.setpoint_position = {i == 2 ? 4.0 : 0.0, 0, 0};
    log.samples.push_back(s);
  }
  const std::string svg = traj::figure::tracking(log);
  EXPECT_TRUE(holds(svg, "f: 3.00 s flown, tracking error 2 m root mean square"));
  EXPECT_TRUE(holds(svg, "largest 4 m"));
  log.samples.resize(1);  // one row has no time to show
  EXPECT_FALSE(holds(traj::figure::tracking(log), "nan"));
}

}  // namespace
