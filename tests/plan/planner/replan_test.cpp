#include "plan/planner/replan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "plan/planner/replanned_record.h"
#include "plan/scenes.h"
#include "support/exact_oracle.h"

namespace plan {
namespace {

using geom::Aabb;
using geom::LegRange;
using geom::Polyline;

const Aabb kBounds{{0, 0, 0}, {100, 100, 40}};
const Vec3 kHalf(0.5, 0.5, 0.5);

bool exactly_free(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    if (oracle::segment_hits(a, b, scene.grown(i))) return false;
  }
  return scene.inside_bounds(a) && scene.inside_bounds(b);
}

ReplanResult replanned(const geom::CollisionScene& scene, const Polyline& path,
                       Quality quality = Quality::normal) {
  Planner planner(scene, nullptr);
  return replan(scene, planner, path, quality);
}

// What must be true of every answer.
void expect_sound(const geom::CollisionScene& scene, const Polyline& old,
                  const ReplanResult& result) {
  const Polyline& path = result.plan.path;
  if (result.plan.status != PathStatus::found) {
    EXPECT_TRUE(path.empty() && result.origin.kept.empty() && result.origin.mended.empty());
    return;
  }
  ASSERT_EQ(path.front(), old.front());
  ASSERT_EQ(path.back(), old.back());
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_TRUE(exactly_free(scene, path[i - 1], path[i])) << "leg " << i - 1;
  }
  std::vector<LegRange> all = result.origin.kept;
  all.insert(all.end(), result.origin.mended.begin(), result.origin.mended.end());
  std::sort(all.begin(), all.end(), [](auto a, auto b) { return a.first < b.first; });
  std::size_t at = 0;
  for (const LegRange& range : all) {
    ASSERT_EQ(range.first, at);
    ASSERT_LT(range.first, range.last);
    at = range.last;
  }
  ASSERT_EQ(at, path.size() - 1);
  auto from = old.begin();
  for (const LegRange& range : result.origin.kept) {  // in order, bit for bit
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = path.begin() + static_cast<std::ptrdiff_t>(range.last) + 1;
    from = std::search(from, old.end(), begin, end);
    ASSERT_TRUE(from != old.end()) << range.first;
  }
}

TEST(Replan, KeepsAFreePathAsItIs) {
  const auto scene = scene_of({{{40, 0, 0}, {60, 40, 40}}}, kBounds, kHalf);
  const Polyline old = {{10, 10, 5}, {30, 70, 5}, {30, 70, 5}, {70, 70, 9}, {90, 10, 5}};
  const ReplanResult result = replanned(scene, old);
  EXPECT_EQ(result.plan.status, PathStatus::found);
  EXPECT_EQ(result.plan.path, old);
  EXPECT_EQ(result.origin.kept, (std::vector<LegRange>{{0, 4}}));
  EXPECT_TRUE(result.origin.mended.empty());
  EXPECT_TRUE(!result.plan.route);
}

TEST(Replan, MendsAroundANewBoxAndKeepsTheRest) {
  const auto scene = scene_of({{{48, 48, 0}, {52, 52, 40}}}, kBounds, kHalf);
  const Polyline old = {{5, 10, 5}, {5, 50, 5}, {40, 50, 5}, {60, 50, 5}, {95, 50, 5}, {95, 10, 5}};
  const ReplanResult result = replanned(scene, old);
  expect_sound(scene, old, result);
  const Polyline& path = result.plan.path;
  ASSERT_EQ(result.origin.mended.size(), 1u);
  EXPECT_EQ(path[0], old[0]);
  EXPECT_EQ(path[1], old[1]);
  EXPECT_EQ(path[path.size() - 2], old[4]);
  EXPECT_LT(geom::length(path), geom::length(old) + 0.2);
}

TEST(Replan, GoesOnToTheNextFreePointWhereAPointIsBlocked) {
  const auto scene = scene_of({{{35, 45, 0}, {45, 55, 40}}}, kBounds, kHalf);
  const Polyline old = {{5, 50, 5}, {40, 50, 5}, {41, 51, 5}, {70, 50, 5}, {95, 50, 5}};
  const ReplanResult result = replanned(scene, old);
  expect_sound(scene, old, result);
  EXPECT_EQ(result.origin.mended.size(), 1u);
  EXPECT_EQ(result.origin.mended[0].first, 0u);
}

TEST(Replan, SaysWhichEndIsBlockedOrOutside) {
  const auto scene = scene_of({{{0, 0, 0}, {20, 20, 20}}}, kBounds, kHalf);
  const Vec3 inside(10, 10, 10);
  const Vec3 free(50, 50, 10);
  EXPECT_EQ(replanned(scene, {inside, free}).plan.status, PathStatus::start_blocked);
  EXPECT_EQ(replanned(scene, {free, {60, 60, 10}, inside}).plan.status, PathStatus::goal_blocked);
  EXPECT_EQ(replanned(scene, {inside}).plan.status, PathStatus::start_blocked);
  EXPECT_EQ(replanned(scene, {free, {50, 50, 400}}).plan.status, PathStatus::goal_outside);
  EXPECT_EQ(replanned(scene, {free}).plan.path, Polyline{free});
}

TEST(Replan, SaysWhereThereIsNoWay) {
  const auto scene = scene_of({{{48, -1, -1}, {52, 101, 41}}}, kBounds, kHalf);
  const ReplanResult result = replanned(scene, {{10, 50, 5}, {40, 50, 5}, {90, 50, 5}});
  EXPECT_EQ(result.plan.status, PathStatus::unreachable);
  EXPECT_TRUE(result.origin.kept.empty());
}

// A kept part that leads into a trap: the mend has to come all the way back.
TEST(Replan, PlansAnewWhereAMendWouldBeMuchLonger) {
  const auto scene = scene_of(
      {{{10, 80, 0}, {90, 82, 40}}, {{10, 18, 0}, {90, 20, 40}}, {{88, 20, 0}, {90, 80, 40}}},
      kBounds, kHalf);
  const Polyline old = {{5, 50, 5},  {20, 50, 5}, {40, 50, 5},
                        {60, 50, 5}, {80, 50, 5}, {97, 50, 5}};
  const ReplanResult result = replanned(scene, old);
  expect_sound(scene, old, result);
  Planner planner(scene, nullptr);
  const PlanResult fresh = planner.plan(old.front(), old.back(), {});
  EXPECT_LE(geom::length(result.plan.path), 1.05 * geom::length(fresh.path));
}

// --- records ------------------------------------------------------------------------------------

geom::PathRecord record_of(const Polyline& points) {
  geom::PathRecord record;
  record.id = "q1";
  record.status = geom::PathStatus::found;
  record.points = points;
  return record;
}

class ReplanProperty : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ReplanProperty, IsSoundForAnyChange) {
  support::Random random(GetParam());
  std::vector<Aabb> boxes;
  const auto tower = [&] {
    const Vec3 low(random.stepped(0, 90, 1), random.stepped(0, 90, 1), 0);
    return Aabb{low, low + Vec3(random.stepped(1, 12, 1), random.stepped(1, 12, 1), 30)};
  };
  for (int i = 0; i < 25; ++i) boxes.push_back(tower());
  const auto before = scene_of(boxes, kBounds, kHalf);
  for (int i = 0; i < 3; ++i) boxes.erase(boxes.begin() + random.below(20));
  for (int i = 0; i < 10; ++i) boxes.push_back(tower());
  const auto after = scene_of(boxes, kBounds, kHalf);
  Planner planner(before, nullptr);
  Planner newer(after, nullptr);
  int mended = 0;
  for (int i = 0; i < 30; ++i) {
    const auto point = [&] {
      return Vec3(random.uniform(1, 99), random.uniform(1, 99), random.uniform(1, 20));
    };
    PlanOptions options;
    if (i % 3 == 0) options.resample = 5;
    const PlanResult old = planner.plan(point(), point(), options);
    if (old.path.empty()) continue;
    for (const Quality quality : {Quality::fast, Quality::normal}) {
      const ReplanResult result = replan(after, newer, old.path, quality);
      SCOPED_TRACE(testing::Message() << "seed " << GetParam() << ", query " << i);
      expect_sound(after, old.path, result);
      geom::PathRecord record = record_of(old.path);
      record.hold.assign(old.path.size(), 1);
      const ReplannedRecord carried = replanned_record(after, record, result);
      if (result.plan.status == PathStatus::found) {
        EXPECT_EQ(std::accumulate(carried.record.hold.begin(), carried.record.hold.end(), 0.0) +
                      static_cast<double>(carried.lost.size()),
                  static_cast<double>(old.path.size()));
      }
      bool all_free = true;
      for (std::size_t k = 1; k < old.path.size(); ++k) {
        all_free = all_free && exactly_free(after, old.path[k - 1], old.path[k]);
      }
      EXPECT_EQ(all_free, result.plan.status == PathStatus::found && result.origin.mended.empty());
      const PlanResult fresh = newer.plan(old.path.front(), old.path.back(), {});
      EXPECT_EQ(result.plan.status, fresh.status);
      mended += !result.origin.mended.empty();
    }
    EXPECT_EQ(replan(before, planner, old.path).plan.path, old.path);
  }
  EXPECT_GT(mended, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplanProperty, testing::Range<std::uint64_t>(1, 21));

}  // namespace
}  // namespace plan
