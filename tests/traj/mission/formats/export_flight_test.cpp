#include "traj/mission/formats/export_flight.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

TEST(ExportFlight, HasASegmentForEachLegOfAPath) {
  geom::PathRecord record{.id = "p", .status = geom::PathStatus::found};
  record.points = {{0, 0, 5}, {9, 0, 5}, {9, 0, 5}, {9, 9, 5}};
  record.hold = {0, 2, 0, 1};
  const ExportFlight flight = export_flight(record);
  EXPECT_EQ(flight.path.size(), 3u);
  ASSERT_EQ(flight.trajectory.segments.size(), 2u);
  EXPECT_EQ(flight.trajectory.segments[1].point.back(), Vec3(9, 9, 5));
  EXPECT_EQ(flight.holds, 3);
  EXPECT_FALSE(flight.has_velocities);
}

TEST(ExportFlight, CountsHowLongATrajectoryStandsStill) {
  TrajectoryRecord record{.id = "t", .status = TrajectoryStatus::solved};
  const State a{Vec3(0, 0, 5)};
  const State b{Vec3(9, 0, 5)};
  record.trajectory.segments = {hermite(a, b, 4), hermite(b, b, 2.5)};
  EXPECT_EQ(export_flight(record).holds, 2.5);
  EXPECT_TRUE(export_flight(record).path.empty());
}

TEST(WhyNotFlown, NamesTheStatusOfARecordThatHoldsNothing) {
  EXPECT_EQ(why_not_flown(TrajectoryRecord{.id = "t", .status = TrajectoryStatus::solved}), "");
  EXPECT_EQ(why_not_flown(TrajectoryRecord{.id = "t", .status = TrajectoryStatus::infeasible}),
            "the record holds no trajectory (status infeasible)");
  EXPECT_EQ(why_not_flown(geom::PathRecord{.id = "p", .status = geom::PathStatus::found}), "");
  EXPECT_EQ(why_not_flown(geom::PathRecord{.id = "p", .status = geom::PathStatus::unreachable}),
            "the record holds no path (status unreachable)");
}

}  // namespace
}  // namespace traj
