#include "plan/bench/trial.h"

#include <gtest/gtest.h>

#include "support/walled_scene.h"

namespace plan::bench {
namespace {

using geom::Vec3;
using support::kAcross;

const geom::CollisionScene& scene() { return support::walled_scene(); }

Verdict judged(const geom::Polyline& path, geom::PathStatus status = geom::PathStatus::found) {
  return judge(scene(), kAcross, {status, path, std::nullopt});
}

TEST(Judge, BelievesNoPath) {
  const Vec3 around1(47, 10, 10);
  const Vec3 around2(53, 10, 10);
  EXPECT_EQ(judged({kAcross.from, around1, around2, kAcross.to}), Verdict::found);
  EXPECT_EQ(judged({kAcross.from, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({kAcross.from, {48, 20, 10}, around2, kAcross.to}),
            Verdict::invalid);  // touches
  EXPECT_EQ(judged({kAcross.from, {47, -1, 10}, around2, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({kAcross.from, around1}), Verdict::invalid);
  EXPECT_EQ(judged({around1, kAcross.to}), Verdict::invalid);
  EXPECT_EQ(judged({}), Verdict::invalid);
}

TEST(Judge, TellsUnreachableFromFailed) {
  EXPECT_EQ(judged({}, geom::PathStatus::unreachable), Verdict::unreachable);
  EXPECT_EQ(judged({}, geom::PathStatus::stopped), Verdict::failed);
  EXPECT_EQ(judged({}, geom::PathStatus::start_blocked), Verdict::failed);
}

TEST(Judge, CountsABlockedOrOutsideEndAsFailedWhateverThePlannerCallsIt) {
  for (const geom::Vec3& end : {geom::Vec3(50, 50, 10), geom::Vec3(-9, 50, 10)}) {
    for (const geom::PlanQuery& query : {geom::PlanQuery{"a", end, {90, 50, 10}, {}, 0},
                                         geom::PlanQuery{"b", {90, 50, 10}, end, {}, 0}}) {
      ASSERT_FALSE(scene().free(end));
      for (const auto status : {geom::PathStatus::unreachable, geom::PathStatus::start_blocked,
                                geom::PathStatus::goal_outside, geom::PathStatus::stopped}) {
        EXPECT_EQ(judge(scene(), query, {status, {}, std::nullopt}), Verdict::failed);
      }
    }
  }
}

}  // namespace
}  // namespace plan::bench
