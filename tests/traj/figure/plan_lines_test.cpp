#include "traj/figure/plan_lines.h"

#include <gtest/gtest.h>

namespace traj::figure {
namespace {

using geom::Axes;

TEST(PlanLines, AreInEnuWhateverTheAxesOfTheRecord) {
  const geom::PathRecord path{
      .id = "q1", .status = geom::PathStatus::found, .points = {{1, 2, 3}, {4, 5, 6}}};
  EXPECT_EQ(plan_line(path, Axes::enu).points, path.points);
  EXPECT_EQ(plan_line(path, Axes::neu).points, (geom::Polyline{{2, 1, 3}, {5, 4, 6}}));
  EXPECT_TRUE(plan_line(path, Axes::enu).corners);
}

TEST(PlanLines, OfATrajectoryReachFromItsBeginToItsEnd) {
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({{0, 0, 1}}, {{10, 2, 3}}, 5)};
  const auto line = plan_line(record, Axes::neu);
  EXPECT_EQ(line.points.front(), Vec3(0, 0, 1));
  EXPECT_NEAR((line.points.back() - Vec3(2, 10, 3)).norm(), 0, 1e-9);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    EXPECT_LT((line.points[i] - line.points[i - 1]).norm(), 0.5) << i;
  }
}

TEST(PlanLines, OfAFlightAreItsRows) {
  FlightLog log{.id = "f"};
  log.samples.resize(2);
  log.samples[1].position = {1, 2, 3};
  const auto line = plan_line(log);
  EXPECT_EQ(line.kind, "flight");
  EXPECT_EQ(line.points, (geom::Polyline{{0, 0, 0}, {1, 2, 3}}));
}

}  // namespace
}  // namespace traj::figure
