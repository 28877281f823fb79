#include "plan/planner/replanned_record.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/planner/replan.h"
#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Polyline;

const geom::Aabb kBounds{{0, 0, 0}, {100, 100, 40}};
const Vec3 kHalf(0.5, 0.5, 0.5);

geom::PathRecord record_of(const Polyline& points) {
  geom::PathRecord record;
  record.id = "q1";
  record.status = geom::PathStatus::found;
  record.points = points;
  return record;
}

ReplannedRecord replanned_of(const geom::CollisionScene& scene, const geom::PathRecord& old) {
  Planner planner(scene);
  return replanned_record(scene, old, replan(scene, planner, old.points));
}

const Polyline kRow = {{5, 50, 5}, {20, 50, 5}, {40, 50, 5}, {60, 50, 5}, {80, 50, 5}, {95, 50, 5}};

TEST(ReplannedRecord, KeepsHoldsAndVelocitiesOfAPathThatIsKept) {
  const auto scene = scene_of({{{50, 10, 0}, {52, 20, 10}}}, kBounds, kHalf);
  geom::PathRecord old = record_of(kRow);
  old.hold = {0, 7, 0, 0, 3, 1};
  old.velocity = {Vec3(1, 0, 0), {}, Vec3(2, 0, 0), {}, {}, {}};
  const ReplannedRecord replanned = replanned_of(scene, old);
  EXPECT_EQ(replanned.record.hold, old.hold);
  EXPECT_EQ(replanned.record.velocity, old.velocity);
  EXPECT_TRUE(replanned.lost.empty());
}

TEST(ReplannedRecord, KeepsTheHoldsThatAreLeftAndSaysWhichAreLost) {
  const auto scene = scene_of({{{38, 45, 0}, {42, 55, 10}}}, kBounds, kHalf);
  geom::PathRecord old = record_of(kRow);
  old.hold = {2, 0, 7, 0, 3, 1};
  old.velocity = {{}, Vec3(1, 0, 0), {}, Vec3(1, 0, 0), {}, {}};
  const ReplannedRecord replanned = replanned_of(scene, old);
  const geom::PathRecord& record = replanned.record;
  ASSERT_EQ(record.status, geom::PathStatus::found);
  ASSERT_EQ(record.hold.size(), record.points.size());
  ASSERT_EQ(record.velocity.size(), record.points.size());
  double total = 0;
  for (std::size_t i = 0; i < record.points.size(); ++i) {
    total += record.hold[i];
    if (record.hold[i] > 0) {
      const auto at = std::find(old.points.begin(), old.points.end(), record.points[i]);
      ASSERT_TRUE(at != old.points.end());
      EXPECT_EQ(record.hold[i], old.hold[static_cast<std::size_t>(at - old.points.begin())]);
    }
  }
  EXPECT_EQ(total, 6) << "all but the one inside the new box";
  EXPECT_NE(std::find(replanned.lost.begin(), replanned.lost.end(), 2u), replanned.lost.end());
}

TEST(Replanned, SaysInTheRecordWhichHoldsAreLost) {
  const auto scene = scene_of({{{38, 45, 0}, {42, 55, 10}}}, kBounds, kHalf);
  Planner planner(scene);
  geom::PathRecord old = record_of(kRow);
  EXPECT_EQ(replanned(scene, planner, old).message, "");
  old.hold = {0, 0, 7, 0, 0, 0};
  EXPECT_EQ(replanned(scene, planner, old).message,
            "the way leaves points 2 of the old path, whose holds and velocities are lost");
}

TEST(Replanned, SaysNothingOfThisMapWhereTheOldRecordHoldsNoPath) {
  const auto scene = scene_of({}, kBounds, kHalf);
  Planner planner(scene);
  geom::PathRecord old{.id = "a", .status = geom::PathStatus::unreachable, .message = "walled in"};
  old.provenance = {.map = "sha256:0", .margin = 2};
  old.bound = 7;
  old.search.emplace();
  old.closed_times = true;
  const geom::PathRecord record = replanned(scene, planner, old);
  EXPECT_EQ(record.id, "a");
  EXPECT_EQ(record.status, geom::PathStatus::stopped);
  EXPECT_EQ(record.message, "no path to replan: the record before says unreachable: walled in");
  EXPECT_EQ(record.provenance.map, scene.map().hash());
  EXPECT_EQ(record.provenance.margin, 2);
  EXPECT_FALSE(record.bound || record.search || record.closed_times);
}

}  // namespace
}  // namespace plan
