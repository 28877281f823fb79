#include "traj/record/record_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace traj {
namespace {

constexpr std::size_t kSphere = 66;    // vertices at each point
constexpr std::size_t kCylinder = 16;  // and of each edge

TEST(RecordParts, HaveASphereAtEachPointAndARodBetween) {
  const geom::PathRecord record{
      .id = "q1", .status = geom::PathStatus::found, .points = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}}};
  const geom::MeshPart part = path_part(record, geom::Axes::enu, 0.3);
  EXPECT_EQ(part.name, "path q1");
  EXPECT_EQ(part.vertices, 3 * kSphere + 2 * kCylinder);
}

TEST(RecordParts, AreInEastNorthUp) {
  const geom::PathRecord record{
      .id = "q1", .status = geom::PathStatus::found, .points = {{0, 0, 5}, {9, 0, 5}}};
  double north = 0;
  const geom::MeshPart part = path_part(record, geom::Axes::neu, 0.3);
  for (std::size_t i = 0; i < part.vertices; ++i) north = std::max(north, part.vertex(i).y());
  EXPECT_NEAR(north, 9.3, 1e-6);
}

TEST(RecordParts, HaveAPointOfACurveEachTenthOfASecond) {
  TrajectoryRecord record{.id = "t"};
  record.trajectory.segments = {hermite({Vec3(0, 0, 5)}, {Vec3(9, 0, 5)}, 2)};
  const geom::MeshPart part = trajectory_part(record, geom::Axes::enu, 0.3);
  EXPECT_EQ(part.vertices, 21 * kSphere + 20 * kCylinder);
}

TEST(RecordParts, HaveARowOfALogEachTenthOfASecondAndTheLast) {
  FlightLog log;
  log.id = "f";
  for (const double t : {0.0, 0.05, 0.1, 0.15}) {
    FlightSample sample;
    sample.time = t;
    sample.position = {t, 0, 5};
    log.samples.push_back(sample);
  }
  EXPECT_EQ(flight_part(log, 0.3).vertices, 3 * kSphere + 2 * kCylinder);
}

TEST(RecordParts, OfACorridorLetThroughWhatIsBehind) {
  CorridorShape shape{"c", {}, {}};
  shape.pieces.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const geom::MeshPart part = corridor_part(shape, geom::Axes::enu);
  EXPECT_EQ(part.triangles, 1u);
  EXPECT_LT(part.opacity, 1);
}

}  // namespace
}  // namespace traj
