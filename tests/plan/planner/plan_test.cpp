#include "plan/planner/plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "plan/lattice/build_lattice.h"
#include "plan/scenes.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};

geom::CollisionScene tower() { return scene_of({{{15, 15, -1}, {25, 25, 30}}}, kCube, {1, 1, 1}); }

// A wall from side to side with a round of 5 m left open at the top.
geom::CollisionScene wall() { return scene_of({{{19, -1, -1}, {21, 41, 35}}}, kCube, {1, 1, 1}); }

geom::CollisionScene sealed() { return scene_of({{{19, -1, -1}, {21, 41, 41}}}, kCube, {1, 1, 1}); }

PlanResult planned(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                   const PlanOptions& options = {}) {
  return Planner(scene, nullptr).plan(from, to, options);
}

void expect_free(const geom::CollisionScene& scene, const geom::Polyline& path) {
  ASSERT_GE(path.size(), 2u);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(scene.free(path[i - 1], path[i])) << "segment " << i;
  }
}

TEST(Planner, IsTheStraightLineWhereThatIsFree) {
  const auto scene = tower();
  const PlanResult result = planned(scene, {2, 2, 2}, {38, 2, 2});
  EXPECT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.route, Route(OwnRoute::straight));
  EXPECT_EQ(result.resolution, 0);
  EXPECT_EQ(result.path, (geom::Polyline{{2, 2, 2}, {38, 2, 2}}));
}

TEST(Planner, RefusesEndsAndLengthsThatAreNone) {
  const auto scene = tower();
  for (const double wrong : {double{NAN}, -double{NAN}, HUGE_VAL, -HUGE_VAL, 1e10, 1e300}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 p(2, 2, 2);
      p[axis] = wrong;
      EXPECT_THROW(planned(scene, p, {38, 2, 2}), geom::InputError) << wrong;
      EXPECT_THROW(planned(scene, {38, 2, 2}, p), geom::InputError) << wrong;
    }
  }
  for (const double wrong : {double{NAN}, -1.0, HUGE_VAL}) {
    PlanOptions options;
    options.snap_ends = wrong;
    EXPECT_THROW(planned(scene, {2, 2, 2}, {38, 2, 2}, options), geom::InputError) << wrong;
    options = {};
    options.resample = wrong;
    EXPECT_THROW(planned(scene, {2, 2, 2}, {38, 2, 2}, options), geom::InputError) << wrong;
  }
}

TEST(Planner, GoesRoundAnObstacle) {
  const auto scene = tower();
  const PlanResult result = planned(scene, {2, 20, 5}, {38, 20, 5});
  ASSERT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.route, Route(OwnRoute::chain));
  EXPECT_EQ(result.resolution, 0);
  EXPECT_EQ(result.path.front(), Vec3(2, 20, 5));
  EXPECT_EQ(result.path.back(), Vec3(38, 20, 5));
  expect_free(scene, result.path);
  const double taut = 2 * std::hypot(12, 6) + 12;
  EXPECT_LT(geom::length(result.path), 1.03 * taut);
}

// Both ends are under roofs, so no half-plane has a chain.
TEST(Planner, FliesFarFromUnderARoofToAnother) {
  std::vector<geom::Aabb> boxes;
  for (const double x : {100.0, 2900.0}) boxes.push_back({{x - 20, 80, 10}, {x + 20, 120, 12}});
  for (int i = 0; i < 20; ++i) {
    const double x = 300 + 120 * i;
    boxes.push_back({{x, 60, -1}, {x + 40, 140, 20.0 + i}});
  }
  const auto scene = scene_of(boxes, {{0, 0, 0}, {3000, 200, 80}}, {1, 1, 1});
  for (const Quality quality : {Quality::fast, Quality::normal, Quality::best}) {
    const PlanResult result = planned(scene, {100, 100, 5}, {2900, 100, 5}, {.quality = quality});
    ASSERT_EQ(result.status, PathStatus::found);
    expect_free(scene, result.path);
    EXPECT_EQ(result.resolution, 0);  // no lattice over all the way
    EXPECT_LT(geom::length(result.path), quality == Quality::fast ? 2840 : 2806);
  }
}

TEST(Planner, RawIsTheLatticePath) {
  const auto scene = tower();
  const PlanResult raw = planned(scene, {2, 20, 5}, {38, 20, 5}, {.raw = true});
  const PlanResult shorter = planned(scene, {2, 20, 5}, {38, 20, 5});
  ASSERT_EQ(raw.status, PathStatus::found);
  expect_free(scene, raw.path);
  EXPECT_GT(raw.path.size(), shorter.path.size());
  EXPECT_GT(geom::length(raw.path), geom::length(shorter.path));
}

TEST(Planner, IsUnreachableThroughASealedWallAtAnyResolution) {
  const auto scene = sealed();
  const PlanResult result = planned(scene, {2, 20, 5}, {38, 20, 5}, {.keep_cells = true});
  EXPECT_EQ(result.status, PathStatus::unreachable);
  EXPECT_TRUE(result.path.empty());
  EXPECT_EQ(result.resolution, 0);
  EXPECT_EQ(result.route, Route(OwnRoute::cells));
  EXPECT_EQ(result.message.rfind("there is no way: obstacles enclose the ", 0), 0u);
  ASSERT_TRUE(result.enclosure);
  EXPECT_FALSE(result.enclosure->cells.empty());
  EXPECT_FALSE(planned(scene, {2, 20, 5}, {38, 20, 5}).enclosure);
}

TEST(Planner, FindsASlitThatNoLatticeSees) {
  const auto scene =
      scene_of({{{19, 0, 0}, {21, 20, 40}}, {{19, 22.001, 0}, {21, 40, 40}}}, kCube, {1, 1, 1});
  const PlanResult result = planned(scene, {2, 2.1, 5}, {38, 38.3, 5.7});
  ASSERT_EQ(result.status, PathStatus::found);
  expect_free(scene, result.path);
  EXPECT_LT(geom::length(result.path), 55);
  // Two metres are the vehicle's, so nothing is left.
  const auto shut =
      scene_of({{{19, 0, 0}, {21, 20, 40}}, {{19, 22, 0}, {21, 40, 40}}}, kCube, {1, 1, 1});
  EXPECT_EQ(planned(shut, {2, 2.1, 5}, {38, 38.3, 5.7}).status, PathStatus::unreachable);
}

TEST(Planner, StopsWhereAWayIsTooNarrowForNumbers) {
  // Walls of one ulp between them: their middle is one of them.
  double open = 23;
  double shut = 21;
  const auto walls = [](double y) {
    return scene_of({{{19, 0, 0}, {21, 20, 40}}, {{19, y, 0}, {21, 40, 40}}}, kCube, {1, 1, 1});
  };
  const auto leaves_gap = [&](double y) {
    const auto scene = walls(y);
    const auto a = scene.grown(0);
    const auto b = scene.grown(1);
    return std::max(a.min.y(), b.min.y()) > std::min(a.max.y(), b.max.y());
  };
  while (std::nextafter(open, shut) > shut) {
    const double y = shut + 0.5 * (open - shut);
    (leaves_gap(y) ? open : shut) = y;
  }
  const PlanResult result = planned(walls(open), {2, 2.1, 5}, {38, 38.3, 5.7});
  EXPECT_EQ(result.status, PathStatus::stopped);
  EXPECT_NE(result.message.find("too narrow"), std::string::npos);
}

TEST(Planner, SaysThatAnEndIsBlockedAndHowFarTheNearestFreePointIs) {
  const auto scene = tower();
  const PlanResult start = planned(scene, {14.5, 20, 5}, {38, 20, 5});
  EXPECT_EQ(start.status, PathStatus::start_blocked);
  EXPECT_EQ(start.message,
            "start (14.5, 20, 5) is inside obstacle 1; the nearest free point is (13.97, 20, 5), "
            "0.530 m away");
  const PlanResult goal = planned(scene, {2, 20, 5}, {20, 20, 29});
  EXPECT_EQ(goal.status, PathStatus::goal_blocked);
  EXPECT_NE(goal.message.find("goal (20, 20, 29) is inside obstacle 1"), std::string::npos);
  EXPECT_NE(goal.message.find("(20, 20, 31.03), 2.030 m away"), std::string::npos);
}

TEST(Planner, SaysThatAnEndIsOutside) {
  const auto scene = tower();
  const PlanResult start = planned(scene, {0.5, 5, 5}, {38, 20, 5});
  EXPECT_EQ(start.status, PathStatus::start_outside);
  EXPECT_EQ(
      start.message,
      "start (0.5, 5, 5) is outside the bounds: 0.5 m beyond x = 0; the vehicle box with margin "
      "0 m may be from (1, 1, 1) to (39, 39, 39); the nearest free point is (1.03, 5, 5), 0.530 "
      "m away; if nothing stands there, skyway-map bounds MAP --bounds=-1,0,0,40,40,40 makes a "
      "map that reaches there");
  EXPECT_EQ(planned(scene, {2, 20, 5}, {1e6, 0, 0}).status, PathStatus::goal_outside);
  EXPECT_NE(planned(scene, {2, 20, 5}, {1e6, 0, 0}).message.find("(38.97, 1.03, 1.03), 999961"),
            std::string::npos);
  const auto no_room = scene_of({}, kCube, {21, 1, 1});
  EXPECT_EQ(planned(no_room, {20, 20, 5}, {20, 20, 5}).status, PathStatus::start_outside);
}

TEST(Planner, TouchingAnObstacleIsBlockedAndTouchingTheBoundsIsNot) {
  const auto scene = tower();
  EXPECT_EQ(planned(scene, {14, 20, 5}, {2, 20, 5}).status, PathStatus::start_blocked);
  EXPECT_EQ(planned(scene, {1, 1, 1}, {1, 1, 39}).status, PathStatus::found);
}

TEST(Planner, SnapsEndsWithinTheDistanceAskedFor) {
  const auto scene = tower();
  const Vec3 inside(14.5, 20, 5);
  const Vec3 outside(40, 20, 5);
  EXPECT_EQ(planned(scene, inside, outside, {.snap_ends = 0.4}).status, PathStatus::start_blocked);
  const PlanResult result = planned(scene, inside, outside, {.snap_ends = 1.5});
  ASSERT_EQ(result.status, PathStatus::found);
  ASSERT_TRUE(result.snapped_start && result.snapped_goal);
  EXPECT_NEAR((*result.snapped_start - inside).norm(), 0.530, 1e-5);
  EXPECT_NEAR((*result.snapped_goal - Vec3(38.97, 20, 5)).norm(), 0, 1e-5);
  EXPECT_EQ(result.path.front(), *result.snapped_start);
  EXPECT_EQ(result.path.back(), *result.snapped_goal);
  expect_free(scene, result.path);
}

TEST(Planner, WorksOnMapsSmallerThanAnySpacing) {
  const auto room =
      scene_of({{{1, -1, -1}, {1.1, 2.5, 4}}}, {{0, 0, 0}, {2, 3, 2.5}}, {0.1, 0.1, 0.05});
  const PlanResult result = planned(room, {0.3, 0.3, 1}, {1.8, 0.3, 1});
  ASSERT_EQ(result.status, PathStatus::found) << result.message;
  expect_free(room, result.path);
  EXPECT_LT(result.resolution, 1);
}

TEST(Planner, WorksOnFlatMaps) {
  const auto flat = scene_of({{{40, -1, -1}, {60, 80, 9}}}, {{0, 0, 0}, {100, 100, 2}}, {1, 1, 1});
  const PlanResult result = planned(flat, {5, 5, 1}, {95, 5, 1});
  ASSERT_EQ(result.status, PathStatus::found) << result.message;
  expect_free(flat, result.path);
}

// A wall to fly over, and one as high as the map whose end is 6 km away.
TEST(Planner, LooksAroundTheQueryOnLargeMapsAndCoarsensUntilThereIsAWayRound) {
  const geom::Aabb bounds{{0, 0, 0}, {40000, 40000, 500}};
  for (const bool far : {false, true}) {
    const Vec3 corner = far ? Vec3(10100, 26000, 501) : Vec3(10100, 40001, 400);
    const auto scene = scene_of({{{10000, -1, -1}, corner}}, bounds, {1, 1, 1});
    const PlanResult result = planned(scene, {9900, 20000, 50}, {10200, 20000, 50});
    ASSERT_EQ(result.status, PathStatus::found) << result.message;
    EXPECT_EQ(result.resolution > 10, far);
    expect_free(scene, result.path);
  }
}

TEST(Planner, SearchesOnTheLatticeGiven) {
  const auto scene = tower();
  const Lattice lattice = build_lattice(scene, {3, Connectivity::six, {1, 1, 1}});
  const PlanResult result = Planner(scene, &lattice).plan({2, 20, 5}, {38, 20, 5}, {});
  ASSERT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.resolution, 3);
  expect_free(scene, result.path);
}

TEST(Planner, RefusesALatticeWhoseEdgesAreBlockedOnThisMap) {
  const Lattice empty = build_lattice(scene_of({}, kCube), {3, Connectivity::six, {1, 1, 1}});
  const auto scene = tower();
  EXPECT_THROW(Planner(scene, &empty).plan({2, 20, 5}, {38, 20, 5}, {}), geom::InputError);
}

TEST(Planner, AnswersTheSameInAnyOrderAndOnAnyThreads) {
  const auto scene = random_scene(11, 150, 60, Vec3::Constant(0.5));
  std::vector<std::pair<Vec3, Vec3>> queries;
  support::Random random(3);
  const auto anywhere = [&] {
    return Vec3(random.uniform(0, 60), random.uniform(0, 60), random.uniform(0, 60));
  };
  for (int i = 0; i < 40; ++i) {
    const Vec3 from = anywhere();
    queries.push_back({from, anywhere()});
  }
  const auto all = [&](unsigned threads) {
    Planner planner(scene, nullptr);
    std::vector<PlanResult> results(queries.size());
    geom::parallel_for(queries.size(), {threads, {}}, [&](std::size_t i) {
      results[i] = planner.plan(queries[i].first, queries[i].second, {.snap_ends = 1});
    });
    return results;
  };
  const auto one = all(1);
  const auto seven = all(7);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].status, seven[i].status);
    EXPECT_EQ(one[i].path, seven[i].path);
    EXPECT_EQ(one[i].expanded, seven[i].expanded);
    const PlanResult alone = planned(scene, queries[i].first, queries[i].second, {.snap_ends = 1});
    EXPECT_EQ(one[i].path, alone.path);
  }
}

TEST(Planner, FindsTheHoleInAWallAndEveryLegIsFree) {
  const std::vector<geom::Aabb> boxes = {{{48, 0, 0}, {52, 26, 40}}, {{48, 34, 0}, {52, 60, 40}}};
  const auto scene = scene_of(boxes, {{0, 0, 0}, {100, 60, 40}}, {1, 1, 1});
  const PlanResult result = planned(scene, {10, 5, 10}, {90, 5, 10}, {.resample = 5});
  ASSERT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.path.front(), Vec3(10, 5, 10));
  EXPECT_EQ(result.path.back(), Vec3(90, 5, 10));
  EXPECT_LT(geom::length(result.path), 95);
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    EXPECT_LE((result.path[i] - result.path[i - 1]).norm(), 5 + 1e-9);
    for (const geom::Aabb& box : scene.map().boxes()) {
      EXPECT_FALSE(oracle::segment_hits(result.path[i - 1], result.path[i], box, scene.half()));
    }
  }
}

// Nodes at 1, 16 and 31 m see no way over the wall of 36 m.
TEST(Planner, AGivenLatticeHelpsAndIsNoLimitButOfAstar) {
  const auto scene = wall();
  const Lattice lattice =
      build_lattice(scene, {15, Connectivity::twenty_six, scene.free_bounds()->min});
  Planner planner(scene, &lattice);
  const Vec3 from(2, 20, 5);
  const Vec3 to(38, 20, 5);
  EXPECT_EQ(planner.plan(from, to, {.method = kAstar}).status, PathStatus::unreachable);
  const PlanResult result = planner.plan(from, to);
  ASSERT_EQ(result.status, PathStatus::found);
  expect_free(scene, result.path);
  EXPECT_EQ(result.path, planned(scene, from, to).path);
}

// A chimney so narrow that no node of the 10 m lattice is in sight at its foot, and so high that
// all bends of the wood around it are nearer than the way over its rim.
TEST(Planner, LooksFromTheGoalWhereThereIsTooMuchOnTheWayToIt) {
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < 24; ++j) {
      const Vec3 low(10.0 * i - 120, 10.0 * j - 120, 0);
      if (std::abs(low.x() + 1) < 12 && std::abs(low.y() + 1) < 12) continue;
      boxes.push_back({low, low + Vec3(2, 2, 8 + (i * 7 + j * 5) % 9)});
    }
  }
  boxes.push_back({{2, 2, 0}, {4, 9, 195}});
  boxes.push_back({{7, 2, 0}, {9, 9, 195}});
  boxes.push_back({{2, 2, 0}, {9, 4, 195}});
  boxes.push_back({{2, 7, 0}, {9, 9, 195}});
  const auto scene = scene_of(boxes, {{-130, -130, 0}, {130, 130, 250}}, {0.5, 0.5, 0.5});
  const Roadmap roadmap = build_roadmap(scene, {10, 60, {}}, {2, {}});
  Planner planner(scene, nullptr, &roadmap);
  const Vec3 from(-115, -113, 2);
  const Vec3 to(5.5, 5.5, 3);
  const RoadmapResult there = RoadmapSearch(scene, roadmap).search(from, to, {4000});
  const RoadmapResult back = RoadmapSearch(scene, roadmap).search(to, from, {4000});
  EXPECT_TRUE(there.gave_up) << there.settled << " of " << roadmap.bends();
  EXPECT_FALSE(back.gave_up) << back.settled;
  const PlanResult result = planner.plan(from, to);
  ASSERT_EQ(result.status, PathStatus::found);
  EXPECT_EQ(result.route, Route(OwnRoute::roadmap));
  EXPECT_EQ(result.path.front(), from);
  EXPECT_EQ(result.path.back(), to);
  expect_free(scene, result.path);
}

}  // namespace
}  // namespace plan
