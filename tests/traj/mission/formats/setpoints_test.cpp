#include "traj/mission/formats/setpoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/reading.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::example;
using testing::refusal;

TEST(Setpoints, AreTheStatesAtTheirInstants) {
  Trajectory t = example();
  for (Segment& s : t.segments) s.yaw = {0.1, 0.2, 0.4, 0.3, 0.2, 0.6, 0.5, 0.1};
  const auto made = setpoints(t, 10);
  ASSERT_EQ(made.size(), 209u);
  EXPECT_EQ(made.back().time, 20.75);
  for (std::size_t i = 0; i + 1 < made.size(); ++i) {
    const State want = evaluate(t, made[i].time);
    EXPECT_LT((made[i].state.position - want.position).norm(), 1e-12);
    EXPECT_LT((made[i].state.acceleration - want.acceleration).norm(), 1e-12);
  }
  for (std::size_t i = 1; i + 2 < made.size(); ++i) {  // the rate is the slope of the yaw
    if (std::abs(made[i].time - 9.5) < 0.11) continue;
    const double slope = (made[i + 1].yaw - made[i - 1].yaw) / 0.2;
    EXPECT_NEAR(made[i].yaw_rate, slope, 2e-3) << made[i].time;
  }
}

TEST(Setpoints, ComeBackBitForBitInEnuAndToRoundingOfYawInNed) {
  const auto made = setpoints(example(), 7);
  for (const SetpointAxes axes : {SetpointAxes::enu, SetpointAxes::ned}) {
    std::stringstream file;
    write_setpoints(file, made, axes);
    const auto back = read_setpoints(file, "s.csv");
    ASSERT_EQ(back.size(), made.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
      EXPECT_EQ(back[i].time, made[i].time);
      EXPECT_EQ(back[i].state.position, made[i].state.position);
      EXPECT_EQ(back[i].state.velocity, made[i].state.velocity);
      EXPECT_EQ(back[i].state.acceleration, made[i].state.acceleration);
      EXPECT_NEAR(back[i].yaw, made[i].yaw, 1e-15);
      EXPECT_EQ(back[i].yaw_rate, made[i].yaw_rate);
    }
  }
}

TEST(Setpoints, NedIsNorthEastDownWithYawFromNorth) {
  std::ostringstream file;
  write_setpoints(file, {{0.5, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, 0, 0.25}}, SetpointAxes::ned);
  const std::string text = file.str();
  EXPECT_EQ(text.substr(text.find('\n') + 1),
            "0.5,2,1,-3,5,4,-6,8,7,-9,1.5707963267948966,-0.25\n");
}

TEST(Setpoints, OfATableThatNobodyCheckedHaveOneColumnMore) {
  std::stringstream file;
  write_setpoints(file, setpoints(example(), 7), SetpointAxes::ned, false);
  const std::string text = file.str();
  EXPECT_TRUE(text.substr(0, text.find('\n')).ends_with(",yaw_rate_rad_s,unchecked"));
  EXPECT_TRUE(text.ends_with(",1\n"));
  EXPECT_EQ(read_setpoints(file, "s.csv").size(), setpoints(example(), 7).size());
}

TEST(Setpoints, BadTablesAreRefused) {
  const auto read = [](std::istream& in) { read_setpoints(in, "s.csv"); };
  const std::string head =
      "t_s,east_m,north_m,up_m,v_east_m_s,v_north_m_s,v_up_m_s,a_east_m_s2,a_north_m_s2,a_up_m_s2,"
      "yaw_rad,yaw_rate_rad_s\n";
  const std::string row = "1,0,0,0,0,0,0,0,0,0,0,0\n";
  EXPECT_TRUE(refusal("t_s,x_m\n0,1\n", read).starts_with("s.csv:1: expected the header t_s,"));
  EXPECT_EQ(refusal(head + row, read), "s.csv: expected a header and at least two rows");
  EXPECT_EQ(refusal(head + row + row, read), "s.csv:3: t_s must grow, found 1");
  EXPECT_EQ(refusal(head + "1,2\n", read), "s.csv:2: expected 12 columns, found 2");
  EXPECT_EQ(refusal(head + "1,nan\n", read),
            "s.csv:2: column 2 must be a number within 1e8, found \"nan\"");
}

}  // namespace
}  // namespace traj
