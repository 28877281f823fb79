#include "traj/mission/formats/crazyflie.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "support/reading.h"
#include "traj/mission/mavlink/examples.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::example;
using testing::refusal;

using testing::Random;
using testing::scene_of;

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
  EXPECT_EQ(read_crazyflie(support::Text(row + "\n"), "c.csv").trajectory.segments[0].point,
            read_crazyflie(support::Text("Duration,x^0,\r\n" + row + ",\r\n"), "c.csv")
                .trajectory.segments[0]
                .point);
}

TEST(Crazyflie, TakesANoteInItsHeaderThatNobodyCheckedIt) {
  std::stringstream file;
  write_crazyflie(file, example());
  const std::string text = file.str();
  const auto with = [&](const std::string& name) {
    return std::string(text).insert(text.find('\n'), name);
  };
  const Trajectory read =
      read_crazyflie(support::Text(with(",UNCHECKED: not compared with any map")), "c.csv")
          .trajectory;
  EXPECT_EQ(read.segments.size(), example().segments.size());
  EXPECT_THROW(read_crazyflie(support::Text(with(",x^8")), "c.csv"), geom::InputError);
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

// How far Horner's rule may be at one instant, by the exact partial sums: each product and sum adds
// half a unit of its own size (Higham, Accuracy and Stability, 5.1).
double error_at(const std::array<double, 8>& c, double t) {
  constexpr double kUnit = 0x1p-24;
  double y = c[7];
  double error = 0;
  for (int k = 6; k >= 0; --k) {
    const double product = y * t;
    y = product + c[static_cast<std::size_t>(k)];
    error = error * t + kUnit * std::abs(product);
    error += kUnit * std::abs(y);
  }
  return error;
}

TEST(Crazyflie, ItsBoundIsThatOfEveryInstant) {
  Random random(14);
  for (int i = 0; i < 60; ++i) {
    const double duration = random.number(0.5, 5);
    std::array<double, 8> c;  // of x: it grows, falls, or has a hump on the way
    for (std::size_t k = 0; k < c.size(); ++k) {
      const double sign = i % 3 == 2 ? random.number(-1, 1) : i % 3 == 0 ? 1 : -1;
      c[k] = static_cast<float>(sign * random.number(1, 20) / std::pow(duration, k));
    }
    if (i % 4 == 3)
      c = {0, 0, static_cast<float>(200 / duration),
           static_cast<float>(-200 / (duration * duration))};
    std::string row = fmt::format("{}", static_cast<float>(duration));
    for (const double v : c) row += fmt::format(",{}", v);
    for (int k = 0; k < 24; ++k) row += ",0";
    const double bound = read_crazyflie(support::Text(row + "\n"), "c.csv").stray[0].position.x();
    for (int n = 0; n <= 640; ++n) {
      EXPECT_GE(bound, error_at(c, static_cast<float>(duration) * n / 640))
          << i << " part " << n / 10;
    }
  }
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

}  // namespace
}  // namespace traj
