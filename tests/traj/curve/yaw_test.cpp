#include "traj/curve/yaw.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/portable_math.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::random_trajectory;

double yaw_at_end(const Segment& s) { return s.yaw->back(); }

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

TEST(AngleOf, IsTheArcTangentAllAround) {
  for (int i = -3000; i <= 3000; ++i) {
    const double angle = kPi * i / 3001;
    const double r = std::exp(i % 17 - 8);
    EXPECT_NEAR(angle_of(r * std::cos(angle), r * std::sin(angle)), angle, 2e-15);
  }
  EXPECT_EQ(angle_of(1, 0), 0);
  EXPECT_EQ(angle_of(0, 2), kPi / 2);
  EXPECT_EQ(angle_of(-1, 0), kPi);
}

TEST(Yaw, FollowsTheVelocityWhereTheRateAllows) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Trajectory t = random_trajectory(seed, 8);
    YawOptions options;
    options.rate = 1000;
    add_yaw(options, t);
    for (std::size_t i = 0; i + 1 < t.segments.size(); ++i) {
      const State s = evaluate(t.segments[i + 1], 0);
      if (s.velocity.head<2>().norm() < 0.1) continue;
      const double heading = std::atan2(s.velocity.y(), s.velocity.x());
      EXPECT_NEAR(wrapped(yaw_at_end(t.segments[i]) - heading), 0, 1e-9);
    }
  }
}

TEST(Yaw, IsContinuousToItsRateAndNeverTooFast) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Trajectory t = random_trajectory(seed, 8);
    YawOptions options;
    options.rate = 0.2 + 0.1 * seed;
    add_yaw(options, t);
    double rate_before = 0;
    for (std::size_t i = 0; i < t.segments.size(); ++i) {
      const Segment& s = t.segments[i];
      const auto& b = *s.yaw;
      EXPECT_LE(yaw_rate_bound(s), options.rate * (1 + 1e-9));
      EXPECT_NEAR(kDegree * (b[1] - b[0]) / s.duration, rate_before, 1e-9);
      if (i > 0) {
        EXPECT_EQ(b[0], t.segments[i - 1].yaw->back());
      }
      rate_before = kDegree * (b[7] - b[6]) / s.duration;
      // No second and third derivative at the ends.
      EXPECT_NEAR(b[2] - 2 * b[1] + b[0], 0, 1e-12);
      EXPECT_NEAR(b[3] - 2 * b[2] + b[1], 0, 1e-12);
    }
    EXPECT_EQ(rate_before, 0);
  }
}

TEST(Yaw, LooksAtAPointAndStaysWhereItIsOverIt) {
  Trajectory t = random_trajectory(3, 8);
  YawOptions options;
  options.kind = YawOptions::Kind::towards;
  options.rate = 1000;
  options.target = evaluate(t.segments[4], 0).position;
  add_yaw(options, t);
  EXPECT_NEAR(yaw_at_end(t.segments[3]), yaw_at_end(t.segments[2]), 1e-12);
  const Vec3 look = options.target - evaluate(t.segments[6], 0).position;
  EXPECT_NEAR(wrapped(yaw_at_end(t.segments[5]) - std::atan2(look.y(), look.x())), 0, 1e-9);
}

TEST(Yaw, TurnsBetweenLegsThatEndAtRest) {
  const std::vector<State> rests = {
      {Vec3(0, 0, 0)}, {Vec3(10, 0, 0)}, {Vec3(10, 10, 0)}, {Vec3(10, 10, 5)}, {Vec3(0, 10, 5)}};
  Trajectory t;
  for (std::size_t i = 1; i < rests.size(); ++i) {
    t.segments.push_back(hermite(rests[i - 1], rests[i], 10));
  }
  add_yaw({}, t);
  const double quarter = 1.5707963267948966;
  EXPECT_NEAR(t.segments[0].yaw->front(), 0, 1e-12);
  EXPECT_NEAR(t.segments[1].yaw->front(), quarter, 1e-12);
  EXPECT_NEAR(t.segments[2].yaw->front(), quarter, 1e-12);  // straight up
  EXPECT_NEAR(t.segments[3].yaw->front(), 2 * quarter, 1e-12);
  EXPECT_NEAR(t.segments[3].yaw->back(), 2 * quarter, 1e-12);
}

TEST(Yaw, FixedIsFixed) {
  Trajectory t = random_trajectory(4, 8);
  YawOptions options;
  options.kind = YawOptions::Kind::fixed;
  options.angle = 2;
  add_yaw(options, t);
  for (const Segment& s : t.segments) {
    for (const double b : *s.yaw) EXPECT_EQ(b, 2);
  }
}

TEST(YawAt, IsThePolynomialAndTheLaterSegmentAtAJoint) {
  Trajectory t = random_trajectory(5, 6);
  EXPECT_EQ(yaw_at(t, 1), std::nullopt);
  add_yaw({}, t);
  double begin = 0;
  for (const Segment& s : t.segments) {
    for (const double u : {0.0, 0.25, 0.7}) {
      double sum = 0;  // from the definition
      for (int i = 0; i < kPoints; ++i) {
        sum += std::tgamma(8) / std::tgamma(i + 1) / std::tgamma(8 - i) * std::pow(u, i) *
               std::pow(1 - u, kDegree - i) * (*s.yaw)[i];
      }
      EXPECT_NEAR(*yaw_at(t, begin + u * s.duration), sum, 1e-9);
    }
    begin += s.duration;
  }
  EXPECT_EQ(yaw_at(t, begin + 1), t.segments.back().yaw->back());
  EXPECT_EQ(yaw_at(t, -1), t.segments.front().yaw->front());
}

TEST(Yaw, KeepsTheFirstHeadingBeforeItMoves) {
  Trajectory hover{{hermite({}, {}, 1)}};
  add_yaw({}, hover);
  for (const double b : *hover.segments[0].yaw) EXPECT_EQ(b, 0);
}

}  // namespace
}  // namespace traj
