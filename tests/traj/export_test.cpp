#include <gtest/gtest.h>

#include <sstream>

#include "geom/error.h"
#include "traj/export/crazyflie.h"
#include "traj/export/setpoints.h"

namespace traj {
namespace {

Trajectory example() {
  const State a{{300.25, -120.5, 20}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const State b{{340, -100, 25}, {5, 1, 0.5}, {0.1, 0, 0}, Vec3::Zero()};
  const State c{{380, -130, 22}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  return {{hermite(a, b, 9.5), hermite(b, c, 11.25)}};
}

class BothFrames : public testing::TestWithParam<geom::Axes> {};

TEST_P(BothFrames, CrazyflieComesBackToSinglePrecision) {
  std::stringstream file;
  write_crazyflie(file, example(), GetParam());
  const Trajectory back = read_crazyflie(file, "c.csv", GetParam());
  for (double t = 0; t < 20.7; t += 0.1) {
    EXPECT_LT((evaluate(back, t).position - evaluate(example(), t).position).norm(), 2e-3) << t;
  }
}

TEST_P(BothFrames, SetpointsComeBackAtTheirInstants) {
  std::stringstream file;
  write_setpoints(file, example(), GetParam(), 10);
  const Trajectory back = read_setpoints(file, "s.csv", GetParam());
  double t = 0;
  for (const Segment& s : back.segments) {
    EXPECT_EQ(s.point[0], evaluate(example(), t).position);
    t += s.duration;
  }
}

INSTANTIATE_TEST_SUITE_P(Frames, BothFrames, testing::Values(geom::Axes::enu, geom::Axes::neu));

TEST(Crazyflie, WritesEastFirstWhateverTheMapsAxes) {
  std::stringstream file;
  write_crazyflie(file, example(), geom::Axes::neu);
  std::string header;
  std::string row;
  std::getline(file, header);
  std::getline(file, row);
  EXPECT_EQ(header.substr(0, 20), "duration,x^0,x^1,x^2");
  EXPECT_EQ(row.substr(0, 11), "9.5,-120.5,");
}

TEST(Exports, BadTablesAreRefused) {
  for (const char* text : {"", "duration\n", "1,2,3\n",
                           "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"}) {
    std::istringstream in(text);
    EXPECT_THROW(read_crazyflie(in, "c.csv", geom::Axes::enu), geom::InputError) << text;
  }
  std::istringstream in("t_s,x_m\n0,1\n");
  EXPECT_THROW(read_setpoints(in, "s.csv", geom::Axes::enu), geom::InputError);
}

}  // namespace
}  // namespace traj
