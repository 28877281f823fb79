#include "traj/flight/reference.h"

#include <gtest/gtest.h>

#include "traj/curve/yaw.h"
#include "traj/scenes.h"

namespace traj {
namespace {

TEST(ReferenceTrack, IsTheTrajectory) {
  Trajectory trajectory = testing::random_trajectory(11);
  add_yaw({}, trajectory);
  const ReferenceTrack track(trajectory);
  std::size_t cursor = 0;
  for (double t = 0; t < duration(trajectory); t += 0.037) {
    const State exact = evaluate(trajectory, t);
    const Reference s = track.at(t, cursor);
    EXPECT_LT((s.position - exact.position).norm(), 1e-12);
    EXPECT_LT((s.velocity - exact.velocity).norm(), 1e-11);
    EXPECT_LT((s.acceleration - exact.acceleration).norm(), 1e-10);
    EXPECT_LT((s.jerk - exact.jerk).norm(), 1e-9);
    std::size_t other = 0;
    const double h = 1e-6;
    const double turn = (track.at(t + h, other).yaw - s.yaw) / h;
    EXPECT_NEAR(s.yaw_rate, turn, 1e-3);
  }
  EXPECT_EQ(track.at(-1, cursor).velocity, Vec3::Zero());
  EXPECT_EQ(track.at(1e3, cursor).velocity, Vec3::Zero());
  EXPECT_LT((track.at(1e3, cursor).position - trajectory.segments.back().point[7]).norm(), 1e-12);
}

TEST(ReferenceTrack, HoversBeforeItsStartAndAfterItsEnd) {
  testing::Random random(12);  // moving as it starts and as it ends
  const Trajectory trajectory{{random.segment(), random.segment()}};
  const ReferenceTrack track(trajectory);
  EXPECT_NEAR(track.duration(), duration(trajectory), 1e-12);
  std::size_t cursor = 0;
  const Reference before = track.at(-0.5, cursor);
  EXPECT_EQ(before.position, trajectory.segments[0].point[0]);
  const Reference after = track.at(track.duration() + 0.5, cursor);
  EXPECT_LT((after.position - trajectory.segments.back().point[7]).norm(), 1e-12);
  for (const Reference& r : {before, after}) {
    EXPECT_EQ(r.velocity, Vec3::Zero());
    EXPECT_EQ(r.acceleration, Vec3::Zero());
    EXPECT_EQ(r.jerk, Vec3::Zero());
    EXPECT_EQ(r.yaw, 0) << "where the trajectory has none";
    EXPECT_EQ(r.yaw_rate, 0);
  }
}

}  // namespace
}  // namespace traj
