#include "traj/record/checked_hash.h"

#include <gtest/gtest.h>

#include "traj/curve/trajectory_hash.h"

namespace traj {
namespace {

TEST(CheckedHash, OfATrajectoryIsThatOfItsCurve) {
  TrajectoryRecord record{.id = "a"};
  record.trajectory.segments.resize(2);
  EXPECT_EQ(checked_hash(record), trajectory_hash(record.trajectory));
}

TEST(CheckedHash, OfAPathSeesItsPointsAlone) {
  geom::PathRecord path{.id = "a", .points = {{0, 0, 1}, {1, 2, 3}}};
  const std::string hash = checked_hash(path);
  EXPECT_EQ(hash.size(), 64u);
  path.id = "b";
  path.points[0].x() = -0.0;
  EXPECT_EQ(checked_hash(path), hash);
  path.points[1].z() = 3.5;
  EXPECT_NE(checked_hash(path), hash);
  path.points = {{0, 0, 1}};
  EXPECT_NE(checked_hash(path), hash);
}

TEST(CheckedHash, OfALogSeesTimesAndPlaces) {
  FlightLog log{.id = "a", .samples = {nothing_known(), nothing_known()}};
  log.samples[1].time = 1;
  const std::string hash = checked_hash(log);
  log.samples[1].time = 2;
  EXPECT_NE(checked_hash(log), hash);
  log.samples[1].time = 1;
  log.samples[0].position.y() = 1e-9;
  EXPECT_NE(checked_hash(log), hash);
}

}  // namespace
}  // namespace traj
