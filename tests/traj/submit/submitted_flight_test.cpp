#include "traj/submit/submitted_flight.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const geom::Aabb kTower{{4, -1, 0}, {6, 1, 20}};

geom::CollisionScene city() {
  return {testing::scene_of({kTower}).map(), geom::Vehicle{"cube", Vec3::Constant(0.5)}, 0.2};
}

TrajectoryRecord flight(const Vec3& from, const Vec3& to) {
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({from}, {to}, 10)};
  record.limits[Limit::speed] = 9;
  record.time = {.epoch = "2026-05-04T06:30:00Z", .start = 12.5};
  return record;
}

SubmissionMethod method() {
  SubmissionMethod out{.origin = {47.4, 8.5, 400}};
  out.risk.dimension = 0.7;
  return out;
}

std::string refusal(const TrajectoryRecord& record, const SubmissionMethod& by = method()) {
  const auto scene = city();
  return SubmittedTrajectory(scene, record, by, {}, "t", 1).refusal();
}

// As whoever gets the file reads them.
geom::IntentVolumes read_back(const geom::IntentVolumes& intent) {
  return geom::read_intent_volumes(support::Text(volumes_json(intent)), "v");
}

TEST(SubmittedTrajectory, ItsVolumesHoldItAfterTheyWereRead) {
  const auto scene = city();
  const SubmissionMethod by = method();
  const SubmittedTrajectory one(scene, flight({0, 5, 5}, {9, 5, 5}), by, {}, "t", 1);
  ASSERT_EQ(one.refusal(), "");
  EXPECT_EQ(one.kind(), "trajectory");
  EXPECT_EQ(one.begins(), "2026-05-04T06:30:12.5Z");
  EXPECT_EQ(one.ends(), "2026-05-04T06:30:22.5Z");
  EXPECT_EQ(one.speed(), 9);
  const geom::IntentVolumes intent = read_back(one.intent());
  EXPECT_EQ(one.why_not_held(intent), std::nullopt);
  EXPECT_FALSE(one.certificate().empty());
}

TEST(SubmittedTrajectory, SmallerVolumesDoNotHoldIt) {
  const auto scene = city();
  const SubmissionMethod by = method();
  const SubmittedTrajectory one(scene, flight({0, 5, 5}, {9, 5, 5}), by, {}, "t", 1);
  const geom::IntentVolumes whole = read_back(one.intent());
  geom::IntentVolumes low = whole;
  *low.nominal.front().upper -= 1;
  EXPECT_TRUE(one.why_not_held(low));
  geom::IntentVolumes late = whole;
  late.nominal.front().start = "2026-05-04T06:30:13Z";
  EXPECT_TRUE(one.why_not_held(late));
  geom::IntentVolumes fewer = whole;
  fewer.nominal.pop_back();
  EXPECT_TRUE(one.why_not_held(fewer));
  geom::IntentVolumes more = whole;
  more.off_nominal.push_back(whole.nominal.front());
  EXPECT_EQ(one.why_not_held(more), "it has off-nominal volumes, and no returns were asked for");
}

TEST(SubmittedTrajectory, SaysWhyItCannotBeInAFolder) {
  EXPECT_EQ(refusal(flight({0, 0, 5}, {9, 0, 5})), "its check refuses it");
  TrajectoryRecord timeless = flight({0, 5, 5}, {9, 5, 5});
  timeless.time.start.reset();
  EXPECT_TRUE(support::says(refusal(timeless), "no \"start\""));
  TrajectoryRecord unlimited = flight({0, 5, 5}, {9, 5, 5});
  unlimited.limits = {};
  EXPECT_TRUE(support::says(refusal(unlimited), "no limit on its speed"));
  SubmissionMethod tired = method();
  tired.endurance = 9;
  EXPECT_TRUE(support::says(refusal(flight({0, 5, 5}, {9, 5, 5}), tired), "the operation says"));
  tired.endurance = 10;
  EXPECT_EQ(refusal(flight({0, 5, 5}, {9, 5, 5}), tired), "");
  SubmissionMethod weak = method();
  weak.energy = Energy{1000, 110, 0, 0};
  EXPECT_TRUE(support::says(refusal(flight({0, 5, 5}, {9, 5, 5}), weak), "the battery lasts"));
}

TEST(SubmittedTrajectory, ItsClaimsFollowFromItsVolumes) {
  const auto scene = city();
  const SubmissionMethod by = method();
  const SubmittedTrajectory one(scene, flight({0, 5, 5}, {9, 5, 5}), by, {}, "t", 1);
  const geom::IntentVolumes intent = read_back(one.intent());
  const RiskVolumes risk = risk_volumes(intent, one.risk_task(), "q1");
  const FlightClaims claims = one.claims(intent, risk);
  EXPECT_EQ(claims.id, "q1");
  EXPECT_EQ(claims.margin, 0.2);
  EXPECT_EQ(claims.duration, 10);
  EXPECT_EQ(claims.contingency.across, contingency_size(by.risk, 9).across);
  EXPECT_NEAR(claims.top, 5.7, 0.1) << "the vehicle with its margin, rounded up";
  EXPECT_FALSE(claims.returns);
}

}  // namespace
}  // namespace traj
