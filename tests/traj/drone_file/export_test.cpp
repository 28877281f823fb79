#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "geom/base/error.h"
#include "support/refusal.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/setpoints.h"
#include "traj/drone_file/straight_legs.h"
#include "traj/scenes.h"

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
  const Trajectory back = read_crazyflie(file, "c.csv").trajectory;
  for (double t = 0; t < 20.7; t += 0.1) {
    EXPECT_LT((evaluate(back, t).position - evaluate(example(), t).position).norm(), 2e-3) << t;
  }
}

TEST(Crazyflie, TakesACommaAtTheEndOfALineAndCrLf) {
  std::string row = "1";
  for (int i = 0; i < 32; ++i) row += ",0.5";
  std::istringstream plain(row + "\n");
  std::istringstream odd("Duration,x^0,\r\n" + row + ",\r\n");
  EXPECT_EQ(read_crazyflie(plain, "c.csv").trajectory.segments[0].point,
            read_crazyflie(odd, "c.csv").trajectory.segments[0].point);
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

// The firmware's evaluation: Horner's rule in single precision on derivatives that were made in it,
// each product and sum rounded twice or, as a compiler may have it, once.
float horner(std::array<float, 8> c, int order, float t, bool fused) {
  for (int k = 0; k < order; ++k) {
    for (int i = 1; i < 8; ++i) c[i - 1] = static_cast<float>(i) * c[i];
    c[7] = 0;
  }
  float x = 0;
  for (int i = 7; i >= 0; --i) {
    const volatile float product = x * t;  // rounded here
    x = fused ? std::fmaf(x, t, c[i]) : product + c[i];
  }
  return x;
}

// The polynomial itself.
long double polynomial(const std::array<float, 8>& c, int order, long double t) {
  long double x = 0;
  for (int i = 7; i >= order; --i) {
    long double factor = c[i];
    for (int k = 0; k < order; ++k) factor *= i - k;
    x = x * t + factor;
  }
  return x;
}

struct Row {
  float duration;
  std::array<std::array<float, 8>, 3> axis;
};

std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field;
    const auto next = [&] {
      std::getline(fields, field, ',');
      return static_cast<float>(std::stod(field));
    };
    Row row;
    row.duration = next();
    for (auto& axis : row.axis) {
      for (float& c : axis) c = next();
    }
    rows.push_back(row);
  }
  return rows;
}

// The largest error of each derivative at 2,000 times, along x, y and z together for the
// derivatives.
std::array<Vec3, 4> errors_of(const Row& row, bool fused) {
  std::array<Vec3, 4> worst;
  worst.fill(Vec3::Zero());
  for (int n = 0; n <= 2000; ++n) {
    const float t = n == 2000 ? row.duration : row.duration * static_cast<float>(n) / 2000;
    for (int order = 0; order < 4; ++order) {
      for (std::size_t a = 0; a < 3; ++a) {
        const long double want = polynomial(row.axis[a], order, t);
        const long double got = horner(row.axis[a], order, t, fused);
        double& error = worst[static_cast<std::size_t>(order)][static_cast<Eigen::Index>(a)];
        error = std::max(error, static_cast<double>(std::abs(got - want)));
      }
    }
  }
  return worst;
}

TEST(Crazyflie, ItsOwnRoundingIsBoundedAndNotMuchBelowTheBound) {
  Random random(12);
  double most = 0;
  double longest = 0;
  for (int i = 0; i < 60; ++i) {
    const double size = i % 3 == 0 ? 5 : i % 3 == 1 ? 60 : 800;
    const State a{random.vector(size)};
    const State b{random.vector(size), i % 2 ? random.vector(5) : Vec3::Zero()};
    std::stringstream file;
    write_crazyflie(file, {{hermite(a, b, random.number(1, 4) * std::sqrt(size))}});
    const Row row = rows_of(file.str())[0];
    const CrazyflieFlight flight = read_crazyflie(file, "c.csv");
    ASSERT_EQ(flight.stray.size(), 1u);
    const Stray& stray = flight.stray[0];
    for (const bool fused : {false, true}) {
      const auto errors = errors_of(row, fused);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(errors[0][axis], stray.position[axis]) << "case " << i;
      }
      EXPECT_LE(errors[1].norm(), stray.velocity) << "case " << i;
      EXPECT_LE(errors[2].norm(), stray.acceleration) << "case " << i;
      EXPECT_LE(errors[3].norm(), stray.jerk) << "case " << i;
      if (fused) continue;
      EXPECT_LE(stray.position.norm(), 20 * errors[0].norm()) << "case " << i;
      most = std::max(most, errors[0].norm() / stray.position.norm());
      longest = std::max(longest, stray.position.norm());
    }
  }
  EXPECT_GT(most, 0.3) << "a bound three times too large at its best";
  EXPECT_LT(longest, 0.05) << "800 m: centimetres at most";
  RecordProperty("closest", std::to_string(most));
  RecordProperty("longest_m", std::to_string(longest));
}

TEST(Crazyflie, WhatItsRoundingReachesIsRefused) {
  const geom::CollisionScene scene = scene_of({{{-50, 10, 0}, {100, 20, 40}}});
  const auto reason = [&](double beside) {
    const State a{{20, -60, 20}};
    const State b{{20, 10 - beside, 20}};
    std::stringstream file;
    write_crazyflie(file, {{hermite(a, b, 20)}});
    CrazyflieFlight flight = read_crazyflie(file, "c.csv");
    CheckOptions options;
    EXPECT_EQ(check(scene, flight.trajectory, options).reason, Reason::none) << "without it";
    options.stray = flight.stray;
    const CheckResult result = check(scene, flight.trajectory, options);
    EXPECT_EQ(result.box.has_value(), !result.ok);
    return result.reason;
  };
  EXPECT_EQ(reason(4e-4), Reason::collision);
  EXPECT_EQ(reason(5e-3), Reason::none);
}

TEST(Crazyflie, FlightsBeyondItsClockAndOtherColumnsAreRefused) {
  const auto read = [](std::istream& in) { read_crazyflie(in, "c.csv"); };
  std::string zeros;
  for (int i = 0; i < 32; ++i) zeros += ",0";
  EXPECT_EQ(refusal("65536" + zeros + "\n", read), "");
  EXPECT_TRUE(refusal("65000" + zeros + "\n600" + zeros + "\n", read)
                  .starts_with("c.csv:2: expected a flight of at most 65536 s"));
  EXPECT_TRUE(refusal("1e15" + zeros + "\n", read).starts_with("c.csv:1: expected a flight of"));
  EXPECT_TRUE(refusal("duration,y^0\n1" + zeros + "\n", read)
                  .starts_with("c.csv:1: expected the header duration,x^0"));
  EXPECT_EQ(refusal("1" + zeros, read),
            "c.csv:1: expected a line that ends with LF, found none: the file may be cut");
}

TEST(Crazyflie, BadTablesAreRefused) {
  const auto read = [](std::istream& in) { read_crazyflie(in, "c.csv"); };
  std::string zeros = "0";
  for (int i = 0; i < 32; ++i) zeros += ",0";
  EXPECT_EQ(refusal("", read), "c.csv: expected at least one row of 33 columns, found none");
  EXPECT_EQ(refusal("1,2,3\n", read),
            "c.csv:1: expected 33 columns (separated by commas, decimals by a point), found 3");
  EXPECT_EQ(refusal(zeros + "\n", read), "c.csv:1: duration must be > 0, found 0");
  EXPECT_EQ(refusal("1,5;0,0;" + zeros + "\n", read),
            "c.csv:1: column 2 must be a number, found \"5;0\"");
  EXPECT_EQ(refusal("1" + zeros.substr(1, 60) + ",1e300\n", read),
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
