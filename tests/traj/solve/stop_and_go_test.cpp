#include "solve/stop_and_go.h"

#include <gtest/gtest.h>

#include <cmath>

#include "traj/proof/check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

struct Peaks {
  double speed = 0;
  double acceleration = 0;
  double jerk = 0;
  double tilt = 0;
};

Peaks sampled(const Segment& s) {
  Peaks peaks;
  for (int i = 0; i <= 2000; ++i) {
    const State x = evaluate(s, s.duration * i / 2000);
    peaks.speed = std::max(peaks.speed, x.velocity.norm());
    peaks.acceleration = std::max(peaks.acceleration, x.acceleration.norm());
    peaks.jerk = std::max(peaks.jerk, x.jerk.norm());
    const Vec3& a = x.acceleration;
    peaks.tilt = std::max(peaks.tilt, std::atan2(std::hypot(a.x(), a.y()), a.z() + kGravity));
  }
  return peaks;
}

TEST(StopAndGo, HasControlPointsAtTheEndsOfTheLegOnly) {
  const Vec3 a(0.1, 0.2, 0.3);
  const Vec3 b(10.1, -3.7, 5);
  const Trajectory t =
      stop_and_go(std::vector<Vec3>{a, b}, {{Limit::speed, 8}, {Limit::acceleration, 6}});
  ASSERT_EQ(t.segments.size(), 1u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(t.segments[0].point[k], k < 4 ? a : b);
}

TEST(StopAndGo, TakesTheShortestTimeOfEachLimit) {
  const std::vector<Vec3> path{Vec3::Zero(), Vec3(20, 10, 5)};
  const Peaks speed = sampled(stop_and_go(path, {{Limit::speed, 3}}).segments[0]);
  EXPECT_NEAR(speed.speed, 3, 1e-6);
  const Peaks acceleration = sampled(stop_and_go(path, {{Limit::acceleration, 2}}).segments[0]);
  EXPECT_NEAR(acceleration.acceleration, 2, 1e-5);
  const Peaks jerk = sampled(stop_and_go(path, {{Limit::jerk, 4}}).segments[0]);
  EXPECT_NEAR(jerk.jerk, 4, 1e-5);
  const Peaks tilt = sampled(stop_and_go(path, {{Limit::tilt, 0.5}}).segments[0]);
  EXPECT_NEAR(tilt.tilt, 0.5, 1e-5);
}

TEST(StopAndGo, TurnsTheThrustNoFasterThanItMay) {
  Limits limits;
  limits[Limit::acceleration] = 8;
  limits[Limit::body_rate] = 2;
  const geom::CollisionScene scene = testing::scene_of({});
  for (const double length : {0.01, 0.3, 5.0, 80.0}) {
    const std::vector<Vec3> path{Vec3(0, 0, 5), Vec3(length, 0, 5),
                                 Vec3(length, 0, 5 + length / 2)};
    EXPECT_LE(check(scene, stop_and_go(path, limits), Limits{}).largest[Limit::body_rate]->value, 2)
        << length;
  }
}

TEST(StopAndGo, SkipsLegsOfNoLength) {
  const std::vector<Vec3> path{Vec3::Zero(), Vec3::Zero(), Vec3(1, 0, 0), Vec3(1, 0, 0)};
  EXPECT_EQ(stop_and_go(path, {{Limit::speed, 8}, {Limit::acceleration, 6}}).segments.size(), 1u);
}

TEST(StopAndGo, OfOnePlaceRestsForASecond) {
  const Trajectory t =
      stop_and_go(std::vector<Vec3>{Vec3(1, 2, 3)}, {{Limit::speed, 8}, {Limit::acceleration, 6}});
  ASSERT_EQ(t.segments.size(), 1u);
  EXPECT_EQ(t.segments[0].duration, 1);
  EXPECT_EQ(evaluate(t, 0.5).position, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace traj
