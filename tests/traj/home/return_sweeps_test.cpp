#include "traj/home/return_sweeps.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/thin_return.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using support::Random;

constexpr double kHair = 1e-7;  // m: for the rounding of the oracle

bool holds(const Prism& prism, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(kHair);
  return meets(prism, {p - hair, p + hair});
}

bool holds(const std::vector<ReturnSweep>& sweeps, const Vec3& p) {
  return std::any_of(sweeps.begin(), sweeps.end(),
                     [&](const ReturnSweep& one) { return holds(one.region, p); });
}

struct Leaving {
  FlightStage stage;
  Vec3 at;
  Vec3 velocity;
};

// Somewhere high on a curve.
Leaving any_leaving(Random& random, unsigned seed) {
  Trajectory trajectory = testing::random_trajectory(seed, 1);
  for (Vec3& p : trajectory.segments[0].point) p += Vec3(0, 0, 60);
  const double t = random.uniform(0, duration(trajectory));
  const State state = evaluate(trajectory, t);
  FlightStage stage = stages_of(trajectory).front();
  for (int i = random.below(6); i > 0; --i) {
    const auto parts = halves(stage);
    stage = parts->first.until >= t ? parts->first : parts->second;
  }
  return {stage, state.position, state.velocity};
}

// Each way that an autopilot's documents allow lies in the regions, whatever it chooses.
TEST(ReturnSweeps, HoldTheThinWaysOfAllInstants) {
  Random random(1);
  for (int i = 0; i < support::cases(3000); ++i) {
    const ReturnModel model = support::any_return_model(random);
    const Leaving leaving = any_leaving(random, static_cast<unsigned>(i));
    ReturnTask task;
    task.home = {random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(0, 5)};
    const bool rally = random.below(2);
    const Vec3 place =
        rally ? Vec3(random.uniform(-80, 80), random.uniform(-80, 80), 30) : task.home;
    const ReturnPlace to{{place.x(), place.y(), task.home.z()}, place.z() - task.home.z()};
    const auto sweeps = return_sweeps(model, leaving.stage, to);
    const auto way = support::way_home(model, task, leaving.at, leaving.velocity, place,
                                       support::any_choice(random));
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      for (const double share : {0.0, random.uniform(0, 1), 1.0}) {
        const Vec3 p = way[k] + share * (way[k + 1] - way[k]);
        ASSERT_TRUE(holds(sweeps, p))
            << "case " << i << ", " << model.autopilot << ", part " << k << ": " << p.transpose();
      }
    }
  }
}

TEST(LandingSweeps, HoldTheWayDownFromWhereItRests) {
  Random random(2);
  for (int i = 0; i < support::cases(500); ++i) {
    const ReturnModel model = support::any_return_model(random);
    const Leaving leaving = any_leaving(random, static_cast<unsigned>(i));
    const Vec3 rest = support::rest(model, leaving.at, leaving.velocity, random.uniform(0, 1));
    const auto holding = holding_sweeps(model, leaving.stage);
    EXPECT_TRUE(holds(holding, leaving.at));
    EXPECT_TRUE(holds(holding, rest));
    const auto landing = landing_sweeps(model, leaving.stage, 0, -3);
    EXPECT_TRUE(holds(landing, rest));
    EXPECT_TRUE(holds(landing, {rest.x(), rest.y(), -3}));
    EXPECT_TRUE(holds(landing, {rest.x(), rest.y(), 20}));
  }
}

// A thin model has nothing to spare: a vehicle at rest goes along three lines.
TEST(ReturnSweeps, OfAVehicleAtRestAreNarrow) {
  Random random(3);
  ReturnModel model = support::thin_return_model(random);
  model.height = 50;
  FlightStage stage;
  stage.where = {{40, 0, 20}};
  const auto sweeps = return_sweeps(model, stage, {{0, 0, 0}, 0});
  for (const Vec3& p : {Vec3(40, 0.1, 30), Vec3(40.1, 0, 30), Vec3(20, 0, 40), Vec3(20, 0.1, 50),
                        Vec3(20, 0, 50.1), Vec3(0, 0.1, 20), Vec3(-0.1, 0, 50)}) {
    EXPECT_FALSE(holds(sweeps, p)) << p.transpose();
  }
  for (const Vec3& p :
       {Vec3(40, 0, 20), Vec3(40, 0, 50), Vec3(20, 0, 50), Vec3(0, 0, 50), Vec3(0, 0, 0)}) {
    EXPECT_TRUE(holds(sweeps, p)) << p.transpose();
  }
}

TEST(ReturnSweeps, StandOnTheGroundOnlyWhereTheyTouchIt) {
  FlightStage stage;
  stage.where = {{40, 0, 20}};
  for (const ReturnSweep& one : return_sweeps(return_model(px4()), stage, {{0, 0, 3}, 0})) {
    if (one.phase == ReturnPhase::descent) {
      EXPECT_EQ(one.stands_on, 3);
    } else {
      EXPECT_FALSE(one.stands_on);
    }
  }
}

TEST(ReturnSweeps, HoldBothHeightsWhereACeilingMayNotCount) {
  FlightStage stage;
  stage.where = {{100, 0, 20}};
  ReturnModel model = return_model(ardupilot());
  model.height = 60;
  model.ceiling = 40;
  const auto across = [&](double z) {
    return holds(return_sweeps(model, stage, {{0, 0, 0}, 0}), {50, 0, z});
  };
  EXPECT_TRUE(across(40));
  EXPECT_FALSE(across(60));
  model.keeps_below_ceiling = false;
  EXPECT_TRUE(across(40));
  EXPECT_TRUE(across(60));
}

TEST(LongestSeconds, AreMoreThanTheWayTakes) {
  Random random(4);
  for (int i = 0; i < support::cases(300); ++i) {
    const ReturnModel model = support::any_return_model(random);
    const Leaving leaving = any_leaving(random, static_cast<unsigned>(i));
    ReturnTask task;
    task.home = {random.uniform(-800, 800), random.uniform(-80, 80), 0};
    const auto sweeps = return_sweeps(model, leaving.stage, {task.home, 0});
    const auto way = support::way_home(model, task, leaving.at, leaving.velocity, task.home, {});
    double seconds = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const Vec3 step = way[k] - way[k - 1];
      const double fast = step.z() > 0 ? model.climb : step.z() < 0 ? model.descent : model.speed;
      seconds += step.norm() / fast;
    }
    EXPECT_GT(longest_seconds(model, sweeps), seconds) << "case " << i;
  }
}

TEST(SweepOfReturn, HasTheCornersOfItsRegion) {
  const ReturnSweep one{{{{0, 0}, {1, 0}, {0, 1}}, 2, 5}, ReturnPhase::way, 1.5};
  const Sweep sweep = sweep_of(one, {7, Manoeuvre::leg});
  EXPECT_EQ(sweep.hull.size(), 6u);
  EXPECT_EQ(sweep.part.item, 7u);
  EXPECT_EQ(sweep.stands_on, 1.5);
}

}  // namespace
}  // namespace traj
