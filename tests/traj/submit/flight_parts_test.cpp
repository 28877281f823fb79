#include "traj/submit/flight_parts.h"

#include <gtest/gtest.h>

#include "geom/record/volume4d.h"
#include "support/reading.h"
#include "traj/scenes.h"
#include "traj/submit/risk_geojson.h"

namespace traj {
namespace {

const geom::Aabb kTower{{4, -1, 0}, {6, 1, 20}};

FlightParts parts_of(const Vec3& from, const Vec3& to) {
  const geom::CollisionScene scene{testing::scene_of({kTower}).map(),
                                   geom::Vehicle{"cube", Vec3::Constant(0.5)}, 0.2};
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({from}, {to}, 10)};
  record.limits[Limit::speed] = 9;
  record.time = {.epoch = "2026-05-04T06:30:00Z", .start = 12.5};
  SubmissionMethod method{.origin = {47.4, 8.5, 400}};
  method.risk.dimension = 0.7;
  return flight_parts(SubmittedTrajectory(scene, record, method, {}, "t", 1), scene.map());
}

TEST(FlightParts, HaveAllOfAFlightThatHolds) {
  const FlightParts parts = parts_of({0, 5, 5}, {9, 5, 5});
  EXPECT_EQ(parts.refusal, "");
  EXPECT_EQ(parts.id, "q1");
  EXPECT_EQ(parts.claims.id, "q1");
  EXPECT_FALSE(geom::read_intent_volumes(support::Text(parts.volumes), "v").nominal.empty());
  EXPECT_EQ(read_risk_geojson(parts.risk, "r").volumes.buffers.size(), parts.buffers.size());
  EXPECT_FALSE(parts.certificate.empty());
}

TEST(FlightParts, SayWhyAFlightIsRefusedAndNothingElse) {
  const FlightParts parts = parts_of({0, 0, 5}, {9, 0, 5});  // through the tower
  EXPECT_NE(parts.refusal, "");
  EXPECT_EQ(parts.id, "q1");
  EXPECT_TRUE(parts.volumes.empty() && parts.risk.empty() && parts.certificate.empty());
}

}  // namespace
}  // namespace traj
