#include "traj/curve/trajectory_hash.h"

#include <gtest/gtest.h>

#include "traj/curve/yaw.h"
#include "traj/record/trajectory_record.h"
#include "traj/scenes.h"

namespace traj {
namespace {

TEST(TrajectoryHash, TellsEveryNumberApart) {
  Trajectory one = testing::random_trajectory(3, 2);
  const std::string hash = trajectory_hash(one);
  EXPECT_EQ(hash, trajectory_hash(one));
  for (Segment& segment : one.segments) {
    std::vector<double*> numbers{&segment.duration};
    for (Vec3& p : segment.point) numbers.insert(numbers.end(), {&p.x(), &p.y(), &p.z()});
    for (double* number : numbers) {
      const double was = *number;
      *number = std::nextafter(was, 1e9);
      EXPECT_NE(trajectory_hash(one), hash);
      *number = was;
    }
  }
  Trajectory turned = one;
  add_yaw({}, turned);
  EXPECT_NE(trajectory_hash(turned), hash);
  one.segments.pop_back();
  EXPECT_NE(trajectory_hash(one), hash);
}

TEST(TrajectoryHash, IsTheSameAfterItWasWrittenAndRead) {
  TrajectoryRecord record{.id = "a", .status = TrajectoryStatus::solved};
  record.trajectory = testing::random_trajectory(5);
  add_yaw({}, record.trajectory);
  record.trajectory.segments[0].point[0].x() = -0.0;
  const TrajectoryRecord read = parse_trajectory_record(to_json_line(record), "t", 1);
  EXPECT_EQ(trajectory_hash(read.trajectory), trajectory_hash(record.trajectory));
}

}  // namespace
}  // namespace traj
