#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "geom/error.h"
#include "support/refusal.h"
#include "traj/export/crazyflie.h"
#include "traj/export/setpoints.h"
#include "traj/export/straight_legs.h"
#include "traj/scenes.h"
#include "traj/to_enu.h"

namespace traj {
namespace {

using testing::Random;
using testing::scene_of;

Trajectory example() {
  const State a{{300.25, -120.5, 20}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const State b{{340, -100, 25}, {5, 1, 0.5}, {0.1, 0, 0}, Vec3::Zero()};
  const State c{{380, -130, 22}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  return {{hermite(a, b, 9.5), hermite(b, c, 11.25)}};
}

std::string refusal(const std::string& text, void (*read)(std::istream&)) {
  std::istringstream in(text);
  return support::refusal_of([&] { read(in); });
}

TEST(InEnu, SwapsXAndYAndTurnsYawAndIsItsOwnInverse) {
  Trajectory t = example();
  t.segments[0].yaw = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  const Trajectory enu = to_enu(geom::Axes::neu, t);
  EXPECT_EQ(enu.segments[0].point[0], Vec3(-120.5, 300.25, 20));
  EXPECT_DOUBLE_EQ((*enu.segments[0].yaw)[7], std::numbers::pi / 2 - 0.7);
  EXPECT_EQ(to_enu(geom::Axes::neu, enu).segments[1].point, t.segments[1].point);
  EXPECT_EQ(to_enu(geom::Axes::enu, t).segments[1].point, t.segments[1].point);
}

TEST(Crazyflie, ComesBackToSinglePrecision) {
  std::stringstream file;
  write_crazyflie(file, example());
  const Trajectory back = read_crazyflie(file, "c.csv");
  for (double t = 0; t < 20.7; t += 0.1) {
    EXPECT_LT((evaluate(back, t).position - evaluate(example(), t).position).norm(), 2e-3) << t;
  }
}

TEST(Crazyflie, TakesACommaAtTheEndOfALineAndCrLf) {
  std::string row = "1";
  for (int i = 0; i < 32; ++i) row += ",0.5";
  std::istringstream plain(row + "\n");
  std::istringstream odd("Duration,x^0,\r\n" + row + ",\r\n");
  EXPECT_EQ(read_crazyflie(plain, "c.csv").segments[0].point,
            read_crazyflie(odd, "c.csv").segments[0].point);
}

TEST(Crazyflie, CountsItsMemory) {
  Trajectory t = example();
  EXPECT_EQ(crazyflie_memory(t).bytes, 264u);
  EXPECT_EQ(crazyflie_memory(t).compressed_bytes, 8u + 2 * (3 + 3 * 14));
  EXPECT_TRUE(crazyflie_memory(t).fits);
  EXPECT_FALSE(crazyflie_memory(t).compressed_fits) << "300 m are beyond 32.767 m";
  for (Segment& s : t.segments) {
    for (Vec3& p : s.point) p = (p - Vec3(340, -120, 20)) / 2;
  }
  EXPECT_TRUE(crazyflie_memory(t).compressed_fits);
  t.segments.resize(32, t.segments[0]);
  EXPECT_FALSE(crazyflie_memory(t).fits);
  t.segments[0].duration = 65.536;
  EXPECT_FALSE(crazyflie_memory(t).compressed_fits);
}

TEST(Crazyflie, BadTablesAreRefused) {
  const auto read = [](std::istream& in) { read_crazyflie(in, "c.csv"); };
  std::string zeros = "0";
  for (int i = 0; i < 32; ++i) zeros += ",0";
  EXPECT_EQ(refusal("", read), "c.csv: expected at least one row of 33 columns, found none");
  EXPECT_EQ(refusal("1,2,3\n", read),
            "c.csv:1: expected 33 columns (separated by commas, decimals by a point), found 3");
  EXPECT_EQ(refusal(zeros + "\n", read), "c.csv:1: duration must be > 0, found 0");
  EXPECT_EQ(refusal("1,5;0,0;" + zeros, read), "c.csv:1: column 2 must be a number, found \"5;0\"");
  EXPECT_EQ(refusal("1" + zeros.substr(1, 60) + ",1e300", read),
            "c.csv:1: column 32 must be a number, found \"1e300\"");
}

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

TEST(Setpoints, BadTablesAreRefused) {
  const auto read = [](std::istream& in) { read_setpoints(in, "s.csv"); };
  const std::string head =
      "t_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,ax_m_s2,ay_m_s2,az_m_s2,yaw_rad,yaw_rate_rad_s\n";
  const std::string row = "1,0,0,0,0,0,0,0,0,0,0,0\n";
  EXPECT_TRUE(refusal("t_s,x_m\n0,1\n", read).starts_with("s.csv:1: expected the header t_s,"));
  EXPECT_EQ(refusal(head + row, read), "s.csv: expected a header and at least two rows");
  EXPECT_EQ(refusal(head + row + row, read), "s.csv:3: t_s must grow, found 1");
  EXPECT_EQ(refusal(head + "1,2\n", read), "s.csv:2: expected 12 columns, found 2");
  EXPECT_EQ(refusal(head + "1,nan\n", read),
            "s.csv:2: column 2 must be a number within 1e8, found \"nan\"");
}

double distance_to(const geom::Polyline& path, const Vec3& p) {
  double best = 1e300;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 leg = path[i] - path[i - 1];
    const double s = std::clamp((p - path[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (p - path[i - 1] - s * leg).norm());
  }
  return best;
}

TEST(StraightLegs, StayWithinTheToleranceOfTheCurveAndStartAndEndOnIt) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    Trajectory t{{random.segment()}};
    const State end = evaluate(t.segments[0], t.segments[0].duration);
    t.segments.push_back(hermite(end, random.state(10), 2));
    std::size_t last = 0;
    for (const double tolerance : {1.0, 0.1, 0.01}) {
      const geom::Polyline legs = straight_legs(t, tolerance);
      EXPECT_EQ(legs.front(), t.segments.front().point.front());
      EXPECT_EQ(legs.back(), t.segments.back().point.back());
      EXPECT_GE(legs.size(), last);
      last = legs.size();
      for (double s = 0; s < duration(t); s += 0.01) {
        EXPECT_LE(distance_to(legs, evaluate(t, s).position), tolerance) << "case " << i;
      }
    }
  }
}

TEST(StraightLegs, OfAStraightTrajectoryAreOne) {
  const Vec3 a(0, 0, 1);
  const Vec3 b(3, 4, 5);
  EXPECT_EQ(straight_legs({{{2, {a, a, a, a, b, b, b, b}, {}}}}, 1e-3), (geom::Polyline{a, b}));
}

TEST(PushedOff, MovesInnerPointsAwayFromEdgesAndBoundsAndNoEnd) {
  const auto scene = scene_of({{{0, 0, 0}, {10, 10, 10}}});
  const auto moved = pushed_off(
      scene,
      {{-0.001, -0.001, 5}, {-0.001, -0.001, 5}, {5, 10.5, 5}, {50, 50, 100}, {-0.001, -0.001, 5}},
      0.1);
  EXPECT_EQ(moved.front(), Vec3(-0.001, -0.001, 5));
  EXPECT_EQ(moved.back(), Vec3(-0.001, -0.001, 5));
  EXPECT_LT((moved[1] - Vec3(-0.1, -0.1, 5)).norm(), 1e-8);
  EXPECT_EQ(moved[2], Vec3(5, 10.5, 5));
  EXPECT_EQ(moved[3], Vec3(50, 50, 99.9));
}

}  // namespace
}  // namespace traj
