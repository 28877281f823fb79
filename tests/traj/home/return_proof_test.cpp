#include "traj/home/return_proof.h"

#include <gtest/gtest.h>

#include <thread>

#include "geom/base/usage_error.h"
#include "support/cases.h"
#include "support/small_map.h"
#include "support/thin_return.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::Aabb;
using support::Random;

// Brakes at once, and goes exactly where it ought to.
ReturnModel thin(double height = 50) {
  ReturnModel model;
  model.autopilot = "thin";
  model.height = height;
  model.deceleration = 1e6;
  model.jerk = 1e12;
  model.speed = 5;
  model.climb = 3;
  model.descent = 1.5;
  return model;
}

ReturnTask task_of(const ReturnModel& model, const Vec3& home = Vec3::Zero()) {
  ReturnTask task;
  task.models = {model};
  task.home = home;
  return task;
}

// From rest at `a` along a line, 10 s.
Trajectory line(const Vec3& a, const Vec3& b) { return {{hermite(State{a}, State{b}, 10)}}; }

ReturnReport prove(const geom::CollisionScene& scene, const Trajectory& trajectory,
                   const ReturnTask& task) {
  const std::vector<std::vector<FlightStage>> stages(task.models.size(), stages_of(trajectory));
  return prove_return(scene, stages, task);
}

const Aabb kBounds{{-200, -200, 0}, {200, 200, 100}};

geom::CollisionScene scene_of(const std::vector<Aabb>& boxes, const Vec3& half, double margin) {
  return {support::map_of(kBounds, boxes), {"box", half}, margin};
}

const Trajectory kAcross = line({20, -30, 20}, {20, 30, 20});  // past home, 20 m to the east

TEST(ProveReturn, OverAnEmptyMapFromEveryInstant) {
  const ReturnReport report =
      prove(scene_of({}, Vec3(0.3, 0.3, 0.2), 0.5), kAcross, task_of(thin()));
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.share(), 1);
  EXPECT_EQ(report.duration, 10);
  EXPECT_EQ(report.action, "rtl");
  EXPECT_EQ(report.autopilot, "thin");
  EXPECT_EQ(report.height, 50);
  EXPECT_GT(report.longest, 20 / 5.0 + 50 / 1.5);
}

// A mast to the side of the line that one climb meets.
TEST(ProveReturn, ABoxInOneClimbMakesAShortGap) {
  const Aabb mast{{20, 4.9, 30}, {21, 5.1, 40}};
  const ReturnReport report = prove(testing::scene_of({mast}), kAcross, task_of(thin()));
  ASSERT_EQ(report.gaps.size(), 1u);
  const ReturnGap& gap = report.gaps.front();
  EXPECT_EQ(gap.phase, "climb");
  EXPECT_EQ(gap.reason, Reason::collision);
  EXPECT_EQ(gap.box, 0u);
  EXPECT_FALSE(gap.part);  // a curve has no items
  for (double t = 0; t <= 10; t += 0.01) {
    const double y = evaluate(kAcross, t).position.y();
    const bool inside = gap.from <= t && t <= gap.until;
    if (std::abs(y - 5) <= 0.1) {
      EXPECT_TRUE(inside) << t;
    }
    if (std::abs(y - 5) > 1.6) {  // as finely as it is divided
      EXPECT_FALSE(inside) << t;
    }
  }
}

TEST(ProveReturn, NamesWhereEachPhaseMeetsABox) {
  const auto phase_at = [](const Aabb& box) {
    const ReturnReport report = prove(testing::scene_of({box}), kAcross, task_of(thin()));
    return report.gaps.empty() ? std::string_view("") : report.gaps.front().phase;
  };
  EXPECT_EQ(phase_at({{19, -1, 30}, {21, 1, 31}}), "climb");
  EXPECT_EQ(phase_at({{9, -1, 49}, {11, 1, 51}}), "way");
  EXPECT_EQ(phase_at({{-1, -1, 20}, {1, 1, 30}}), "descent");
  EXPECT_EQ(phase_at({{-1, -1, 50}, {1, 1, 60}}), "way");  // the corner above home
  EXPECT_EQ(phase_at({{9, -1, 0}, {11, 1, 49}}), "");      // it passes above
  EXPECT_EQ(phase_at({{9, -1, 51}, {11, 1, 60}}), "");     // and below
}

// What counts is the larger of the margin and what the autopilot and the navigation may be off.
TEST(ProveReturn, TakesTheLargerOfMarginAndAround) {
  const auto is_clear = [](double margin, double around, double room, double gap) {
    ReturnModel model = thin();
    model.around = Vec3::Constant(around);
    ReturnTask task = task_of(model);
    task.room = Vec3::Constant(room);
    // Beside the column above home.
    const Aabb box{{-10, 0.25 + gap, 20}, {-0.25 - gap + 20, 5, 21}};
    return prove(scene_of({box}, Vec3(0.25, 0.25, 0.125), margin), kAcross, task).ok();
  };
  EXPECT_TRUE(is_clear(0.5, 0, 0, 0.51));
  EXPECT_FALSE(is_clear(0.5, 0, 0, 0.5));  // touches
  EXPECT_TRUE(is_clear(0.5, 0.25, 0.25, 0.51));
  EXPECT_TRUE(is_clear(0, 0.25, 0.5, 0.76));
  EXPECT_FALSE(is_clear(0, 0.25, 0.5, 0.75));
  EXPECT_FALSE(is_clear(0.5, 0.25, 0.5, 0.75));
}

TEST(ProveReturn, GoesToTheNearestPlace) {
  const Aabb wall{{-20, -100, 0}, {-15, 100, 90}};  // between the flight and home
  ReturnTask task = task_of(thin(), {-40, 0, 0});
  EXPECT_FALSE(prove(testing::scene_of({wall}), kAcross, task).ok());
  task.rally = {{30, 0, 10}};
  EXPECT_TRUE(prove(testing::scene_of({wall}), kAcross, task).ok());
  task.models.front().any_place = true;
  EXPECT_FALSE(prove(testing::scene_of({wall}), kAcross, task).ok());
  task.models.front().any_place = false;
  task.rally = {{90, 0, 10}};  // home is nearer from somewhere
  EXPECT_FALSE(prove(testing::scene_of({wall}), kAcross, task).ok());
}

TEST(ProveReturn, ToARallyPointGoesAtItsHeight) {
  const Aabb roof{{25, -40, 60}, {29, 40, 62}};
  ReturnTask task = task_of(thin(50), {-90, 0, 0});
  task.rally = {{40, 0, 15}};
  EXPECT_TRUE(prove(testing::scene_of({roof}), kAcross, task).ok());
  task.models.front().rally_adds = true;  // 15 + 50 m
  EXPECT_TRUE(prove(testing::scene_of({roof}), kAcross, task).ok());
  task.models.front().height = 46;  // 61 m
  EXPECT_FALSE(prove(testing::scene_of({roof}), kAcross, task).ok());
}

TEST(ProveReturn, ThatGoesWhereNobodyKnowsIsNeverProved) {
  ReturnModel model = thin();
  model.known = false;
  const ReturnReport report = prove(testing::scene_of({}), kAcross, task_of(model));
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_EQ(report.gaps.front().reason, Reason::return_home);
  EXPECT_EQ(report.gaps.front().from, 0);
  EXPECT_EQ(report.gaps.front().until, 10);
  EXPECT_EQ(report.share(), 0);
}

TEST(ProveReturn, StaysUnderTheCeiling) {
  const ReturnReport report = prove(testing::scene_of({}), kAcross, task_of(thin(101)));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.gaps.front().reason, Reason::bounds);
  EXPECT_TRUE(prove(testing::scene_of({}), kAcross, task_of(thin(99))).ok());
}

TEST(ProveReturn, KeepsToFences) {
  ReturnTask task = task_of(thin());
  task.fences = {{true, {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, 0},
                 {false, {{9, -1}, {11, -1}, {11, 1}, {9, 1}}, 0}};
  const ReturnReport report = prove(testing::scene_of({}), kAcross, task);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.gaps.front().reason, Reason::fence);
  EXPECT_EQ(report.gaps.front().fence, 1u);
  EXPECT_EQ(report.gaps.front().phase, "way");
  EXPECT_LT(report.gaps.front().until - report.gaps.front().from, 5);
  task.fences.pop_back();
  EXPECT_TRUE(prove(testing::scene_of({}), kAcross, task).ok());
}

// Home's ground must be level as far as the vehicle may land beside it.
TEST(ProveReturn, LandsOnLevelGround) {
  const auto lands = [](const Aabb& roof, double margin) {
    ReturnModel model = thin();
    model.around = Vec3::Constant(0.5);
    return prove(scene_of({roof}, Vec3(0.25, 0.25, 0.125), margin), kAcross,
                 task_of(model, {0, 0, roof.max.z()}));
  };
  EXPECT_TRUE(lands({{-9, -9, 0}, {9, 9, 12}}, 0.5).ok());
  EXPECT_TRUE(lands({{-9, -9, 0}, {0.76, 9, 12}}, 0.5).ok());
  for (const double margin : {0.0, 0.5, 2.0}) {
    const ReturnReport report = lands({{-9, -9, 0}, {0.74, 9, 12}}, margin);
    ASSERT_FALSE(report.ok()) << margin;
    EXPECT_EQ(report.gaps.front().reason, Reason::landing);
    EXPECT_EQ(report.gaps.front().phase, "landing");
  }
  // Home in the air, and home below the ground.
  EXPECT_FALSE(prove(testing::scene_of({}), kAcross, task_of(thin(), {0, 0, 4})).ok());
  EXPECT_FALSE(prove(testing::scene_of({}), kAcross, task_of(thin(), {0, 0, -4})).ok());
}

TEST(ProveReturn, InsideABuildingIsNoHome) {
  const ReturnReport report =
      prove(testing::scene_of({{{-9, -9, 0}, {9, 9, 12}}}), kAcross, task_of(thin()));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.gaps.front().phase, "descent");
  EXPECT_EQ(report.share(), 0);
}

// Of a roof that a take-off leaves: it stands on what is not higher, and on nothing else.
TEST(ProveReturn, StandsOnlyOnWhatIsBelow) {
  FlightStage stage;
  stage.from = 0;
  stage.until = 5;
  stage.where = {{20, 0, 12}, {20, 0, 20}};
  stage.stands_on = 12;
  const auto proved = [&](double top) {
    const std::vector<std::vector<FlightStage>> stages{{stage}};
    const auto scene =
        scene_of({{{10, -9, 0}, {30, 9, 12}}, {{20.5, -9, 0}, {30, 9, top}}}, Vec3(1, 1, 0.25), 0);
    return prove_return(scene, stages, task_of(thin())).ok();
  };
  EXPECT_TRUE(proved(12));
  EXPECT_FALSE(proved(12.25));
  stage.stands_on.reset();
  EXPECT_FALSE(proved(12));
}

TEST(ProveReturn, LandingBelowNeedsGroundAsHighAsHome) {
  ReturnTask task = task_of(thin());
  task.action = ReturnAction::land;
  EXPECT_TRUE(prove(testing::scene_of({}), kAcross, task).ok());
  const ReturnReport report = prove(testing::scene_of({{{15, 4, 0}, {25, 6, 9}}}), kAcross, task);
  ASSERT_FALSE(report.ok());
  EXPECT_LT(report.gaps.back().until - report.gaps.front().from, 4);
  for (double t = 0; t <= 10; t += 0.01) {
    const double y = evaluate(kAcross, t).position.y();
    if (y < 4 || y > 6) continue;
    EXPECT_TRUE(std::any_of(report.gaps.begin(), report.gaps.end(), [&](const ReturnGap& gap) {
      return gap.from <= t && t <= gap.until;
    })) << t;
  }
  task.home.z() = -30;  // the ground is higher than at home
  EXPECT_FALSE(prove(testing::scene_of({}), kAcross, task).ok());
}

TEST(ProveReturn, HoldingNeedsTheWayToRestAlone) {
  ReturnTask task = task_of(thin());
  task.action = ReturnAction::hold;
  task.models.front().deceleration = 1;
  const std::vector<Aabb> tower{{{19, 31, 0}, {21, 33, 100}}};  // beyond the end, which is a rest
  EXPECT_FALSE(prove(testing::scene_of(tower), kAcross, task).ok());
  task.models.front().deceleration = 1e6;
  EXPECT_TRUE(prove(testing::scene_of(tower), kAcross, task).ok());
  EXPECT_TRUE(prove(testing::scene_of({{{-5, -5, 0}, {5, 5, 90}}}), kAcross, task).ok());
}

TEST(ProveReturn, CountsBoxesThatMayBeThereWhileItReturns) {
  geom::BoxTable table = support::table_of({{{9, -1, 40}, {11, 1, 60}}});
  const geom::BoxMapSpec spec{.bounds = kBounds, .epoch = "2026-05-04T06:30:00Z"};
  const auto proved = [&](const geom::TimeSpan& span, std::optional<double> start) {
    table.set_time(0, span);
    ReturnTask task = task_of(thin());
    task.start = start;
    const geom::CollisionScene scene({spec, table}, {"box", Vec3::Zero()}, 0);
    return prove(scene, kAcross, task).ok();
  };
  EXPECT_FALSE(proved({100, 200}, {}));  // at any time
  EXPECT_TRUE(proved({100, 200}, 300));  // it is over by then
  EXPECT_FALSE(proved({100, 200}, 100));
  EXPECT_FALSE(proved({100, 200}, 194));  // over while it flies
  EXPECT_FALSE(proved({100, 200}, 90));   // begins while it returns
  EXPECT_TRUE(proved({9000, 9100}, 90));  // long after it landed
}

TEST(ProveReturn, GapsAscendAndAreApart) {
  Random random(1);
  for (int i = 0; i < support::cases(60); ++i) {
    std::vector<Aabb> boxes;
    for (int k = random.below(12); k > 0; --k) {
      const Vec3 low(random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(0, 50));
      boxes.push_back({low, low + Vec3(4, 4, random.uniform(1, 40))});
    }
    ReturnTask task = task_of(support::any_return_model(random));
    task.models.push_back(support::any_return_model(random));
    const Trajectory trajectory = testing::random_trajectory(static_cast<unsigned>(i));
    const ReturnReport report = prove(testing::scene_of(boxes), trajectory, task);
    double before = -1;
    for (const ReturnGap& gap : report.gaps) {
      EXPECT_LE(gap.from, gap.until);
      EXPECT_GE(gap.from, before);
      before = gap.until;
    }
    EXPECT_LE(before, report.duration);
    EXPECT_GE(report.share(), 0);
    EXPECT_LE(report.share(), 1);
  }
}

// Of several autopilots, it is a gap where any of them has one.
TEST(ProveReturn, OfSeveralModelsHoldsForEach) {
  const Aabb bar{{9, -40, 49}, {11, 40, 51}};
  ReturnTask task = task_of(thin(60));
  EXPECT_TRUE(prove(testing::scene_of({bar}), kAcross, task).ok());
  task.models.push_back(thin(50));
  task.models.back().autopilot = "other";
  const ReturnReport report = prove(testing::scene_of({bar}), kAcross, task);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.gaps.front().autopilot, "other");
  EXPECT_EQ(report.autopilot, "thin, other");
  EXPECT_EQ(report.height, 50);
}

TEST(ProveReturn, IsTheSameOnAnyThread) {
  Random random(2);
  const geom::CollisionScene scene = testing::scene_of({{{9, -4, 20}, {11, 4, 70}}});
  const ReturnTask task = task_of(thin());
  const ReturnReport once = prove(scene, kAcross, task);
  std::vector<ReturnReport> again(4);
  std::vector<std::thread> threads;
  for (ReturnReport& one : again) {
    threads.emplace_back([&] { one = prove(scene, kAcross, task); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const ReturnReport& one : again) {
    ASSERT_EQ(one.gaps.size(), once.gaps.size());
    for (std::size_t i = 0; i < one.gaps.size(); ++i) {
      EXPECT_EQ(one.gaps[i].from, once.gaps[i].from);
      EXPECT_EQ(one.gaps[i].until, once.gaps[i].until);
      EXPECT_EQ(one.gaps[i].place, once.gaps[i].place);
    }
  }
}

TEST(ProveReturn, RefusesATaskWithoutModelsOrStages) {
  const auto scene = testing::scene_of({});
  const std::vector<std::vector<FlightStage>> stages{stages_of(kAcross)};
  EXPECT_THROW(prove_return(scene, {}, ReturnTask{}), geom::UsageError);
  ReturnTask task = task_of(thin());
  task.models.push_back(thin());
  EXPECT_THROW(prove_return(scene, stages, task), geom::UsageError);
}

// --- the least height
// -----------------------------------------------------------------------------

ReturnReport prove_at(const geom::CollisionScene& scene, const Trajectory& trajectory,
                      ReturnTask task, double height) {
  for (ReturnModel& model : task.models) model.height = height;
  return prove(scene, trajectory, task);
}

TEST(BestReturnHeight, IsProvedAndNotAStepBelow) {
  Random random(3);
  int found = 0;
  for (int i = 0; i < support::cases(60); ++i) {
    std::vector<Aabb> boxes;
    for (int k = random.below(5); k > 0; --k) {
      const Vec3 low(random.uniform(4, 12), random.uniform(-30, 26), random.below(3) ? 0 : 40);
      boxes.push_back({low, low + Vec3(4, 4, random.uniform(1, 60))});
    }
    const auto scene = testing::scene_of(boxes);
    ReturnTask task = task_of(support::any_return_model(random));
    task.models.front().around = Vec3::Constant(0.25);
    const Trajectory trajectory = line({30, -20, 45}, {30, 20, 45});
    const std::vector<std::vector<FlightStage>> stages{stages_of(trajectory)};
    constexpr double kStep = 0.5;
    const auto best = best_return_height(scene, stages, task, kStep);
    if (!best) continue;
    const ReturnReport there = prove_at(scene, trajectory, task, best->height);
    EXPECT_EQ(there.ok(), best->share == 1) << "case " << i;
    EXPECT_NEAR(there.share(), best->share, 1e-8) << "case " << i;
    if (best->height >= kStep) {
      const ReturnReport below = prove_at(scene, trajectory, task, best->height - kStep);
      EXPECT_FALSE(below.ok()) << "case " << i;
      EXPECT_LE(below.share(), best->share) << "case " << i;
    }
    found += best->share == 1;
  }
  EXPECT_GT(found, 5);
}

TEST(BestReturnHeight, IsAboveTheWallInItsWay) {
  const auto scene = testing::scene_of({{{9, -60, 0}, {11, 60, 63.2}}});
  const std::vector<std::vector<FlightStage>> stages{stages_of(kAcross)};
  const auto best = best_return_height(scene, stages, task_of(thin()));
  ASSERT_TRUE(best);
  EXPECT_EQ(best->height, 63.5);
  EXPECT_EQ(best->share, 1);
}

TEST(BestReturnHeight, ProvesNothingWhereNoneHelps) {
  const std::vector<std::vector<FlightStage>> stages{stages_of(kAcross)};
  const auto walled = testing::scene_of({{{9, -60, 0}, {11, 60, 100}}});
  const auto best = best_return_height(walled, stages, task_of(thin()));
  EXPECT_TRUE(!best || best->share == 0);
  ReturnModel unknown = thin();
  unknown.known = false;
  const auto nowhere = best_return_height(testing::scene_of({}), stages, task_of(unknown));
  EXPECT_TRUE(!nowhere || nowhere->share == 0);
  ReturnTask holds = task_of(thin());
  holds.action = ReturnAction::hold;
  EXPECT_FALSE(best_return_height(testing::scene_of({}), stages, holds));
}

// Below the top of what it stands on, a wall is beside it.
TEST(ProveReturn, APadIsNoExcuseForTheRoofBesideIt) {
  const Aabb pad{{-3, -3, 0}, {3, 3, 20}};
  const Aabb roof{{6, -3, 0}, {10, 3, 20}};  // as high, and within reach while it brakes
  ReturnModel model = thin();
  model.deceleration = 2;
  ReturnTask task = task_of(model, {0, 0, 20});
  task.pads = {{0, 0, 20}};
  task.action = ReturnAction::hold;
  const Trajectory low{{hermite(State{{-1.9, 0, 21}}, State{{1.9, 0, 21}}, 1.5)}};
  const Vec3 half(0.5, 0.5, 1.5);  // its feet are below the roofs' tops
  EXPECT_TRUE(prove(scene_of({pad}, half, 0), low, task).ok());
  EXPECT_FALSE(prove(scene_of({pad, roof}, half, 0), low, task).ok());
}

TEST(ProveReturn, NeedsStages) {
  const std::vector<std::vector<FlightStage>> none(1);
  EXPECT_THROW(prove_return(testing::scene_of({}), none, task_of(thin())), geom::UsageError);
}

TEST(ProveReturn, APadIsNoExcuseForTheWallBelowIt) {
  const Aabb house{{-9, -9, 0}, {0.5, 9, 20}};
  ReturnTask task = task_of(thin(), {40, 0, 0});
  task.action = ReturnAction::hold;
  task.pads = {{0, 0, 20}};
  const Trajectory beside = line({0.6, 0, 18}, {0.6, 0.5, 18});
  EXPECT_FALSE(prove(scene_of({house}, Vec3(0.3, 0.3, 0.2), 0), beside, task).ok());
  const Trajectory above = line({0, 0, 20.25}, {0, 0.5, 20.25});
  EXPECT_TRUE(prove(scene_of({house}, Vec3(0.3, 0.3, 0.2), 0), above, task).ok());
}

}  // namespace
}  // namespace traj
