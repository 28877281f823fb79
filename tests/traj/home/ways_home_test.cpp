#include "traj/home/ways_home.h"

#include <gtest/gtest.h>

#include "geom/base/parallel.h"
#include "support/random_city.h"
#include "support/reading.h"
#include "traj/home/contingency_record.h"
#include "traj/home/home_case.h"
#include "traj/home/home_flight.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::path_of;
using testing::small_vehicle;
using testing::task_of;
using testing::town;

constexpr double kSpeed = 5;  // m/s

TEST(WaysHome, ShareOneWayAlongAStraightFlight) {
  const auto scene = small_vehicle(town({}));
  const auto stages = stages_of(path_of({{10, 10, 20}, {60, 10, 20}}), kSpeed);
  const WaysTask task = task_of(scene, {{90, 10}});
  const WaysHome home = ways_home(scene, stages, task);
  ASSERT_EQ(home.ways.size(), 1u);
  EXPECT_TRUE(home.gaps.empty());
  EXPECT_TRUE(complete(home, task));
  EXPECT_EQ(share(home), 1);
  const WayHome& way = home.ways.front();
  EXPECT_EQ(way.from, 0);
  EXPECT_EQ(way.until, 10);
  EXPECT_EQ(way.points, (geom::Polyline{task.sites[0].above, task.sites[0].ground})) << "straight";
  EXPECT_GT(way.length, (Vec3(90, 10, 5) - Vec3(10, 10, 20)).norm());
  EXPECT_FALSE(way.latest_departure);
}

TEST(WaysHome, TakeTheNearestSite) {
  const auto scene = small_vehicle(town({}));
  const auto stages = stages_of(path_of({{10, 10, 20}, {12, 10, 20}}), kSpeed);
  const WaysHome home = ways_home(scene, stages, task_of(scene, {{90, 90}, {12, 15}, {50, 10}}));
  ASSERT_EQ(home.ways.size(), 1u);
  EXPECT_EQ(home.ways.front().site, 1u);
}

TEST(WaysHome, GoOverWhatStandsBetween) {
  const auto scene = small_vehicle(town({{{40, 0, 0}, {45, 100, 30}}}));
  const auto stages = stages_of(path_of({{10, 50, 10}, {20, 50, 10}}), kSpeed);
  const WaysHome home = ways_home(scene, stages, task_of(scene, {{90, 50}}));
  ASSERT_EQ(share(home), 1);
  double highest = 0;
  for (const Vec3& p : home.ways.front().points) highest = std::max(highest, p.z());
  EXPECT_GT(highest, 30);
  EXPECT_LT(highest, 40) << "no higher than need be";
}

TEST(WaysHome, AskThePlannerWhereThereIsARoof) {
  // A hall without a gap above: the planner knows its door.
  const auto scene = small_vehicle(town(
      {{{0, 0, 32}, {50, 100, 33}}, {{50, 0, 0}, {51, 100, 28}}, {{50, 0, 28}, {51, 90, 60}}}));
  const auto stages = stages_of(path_of({{20, 20, 10}, {24, 20, 10}}), kSpeed);
  WaysTask task = task_of(scene, {{90, 20}});
  EXPECT_EQ(share(ways_home(scene, stages, task)), 0);
  task.plan = [](const Vec3& from, const LandingSite& site) {
    return std::optional(
        geom::Polyline{from, {48, 95, 29}, {53, 95, 29}, {90, 95, 29}, {90, 20, 29}, site.above});
  };
  const WaysHome home = ways_home(scene, stages, task);
  EXPECT_EQ(share(home), 1);
  task.plan = [](const Vec3& from, const LandingSite& site) {
    return std::optional(geom::Polyline{from, site.above});
  };
  EXPECT_EQ(share(ways_home(scene, stages, task)), 0) << "a planner is not believed";
}

TEST(WaysHome, LeaveATimeOutWhereBrakingWouldTouch) {
  const auto scene = small_vehicle(town({{{60, 0, 0}, {70, 100, 50}}}));
  const auto stages = stages_of(path_of({{10, 50, 20}, {59, 50, 20}, {59, 80, 20}}), kSpeed);
  const WaysHome home = ways_home(scene, stages, task_of(scene, {{10, 50}}));
  ASSERT_EQ(home.gaps.size(), 1u);
  EXPECT_GT(home.gaps.front().from, 8);
  EXPECT_NEAR(home.gaps.front().until, 9.8, 1e-9) << "the corner";
  EXPECT_EQ(home.ways.back().until, stages.back().until);
  EXPECT_LT(share(home), 1);
}

TEST(WaysHome, SayUntilWhenTheBatteryIsEnough) {
  const auto scene = small_vehicle(town({}));
  const auto stages = stages_of(path_of({{10, 10, 20}, {60, 10, 20}}), kSpeed);
  WaysTask task = task_of(scene, {{10, 10}});
  task.energy = Energy{.capacity = 100 * 100, .power = 100, .reserve = 0, .wind = 2};
  const WaysHome plenty = ways_home(scene, stages, task);
  EXPECT_TRUE(complete(plenty, task));
  EXPECT_EQ(plenty.ways.back().latest_departure, plenty.ways.back().until);
  const double seconds = plenty.ways.front().duration;
  task.energy->capacity = 100 * (seconds + 4);
  const WaysHome scarce = ways_home(scene, stages, task);
  EXPECT_FALSE(complete(scarce, task));
  EXPECT_TRUE(scarce.gaps.empty());
  ASSERT_TRUE(scarce.ways.front().latest_departure);
  EXPECT_NEAR(*scarce.ways.front().latest_departure, 4, 1e-9);
  task.energy->capacity = 1;
  EXPECT_FALSE(ways_home(scene, stages, task).ways.front().latest_departure);
}

TEST(WaysHome, TakeLongerAgainstTheWind) {
  const auto scene = small_vehicle(town({}));
  const auto stages = stages_of(path_of({{90, 10, 20}, {91, 10, 20}}), kSpeed);
  WaysTask task = task_of(scene, {{10, 10}});
  task.energy = Energy{.capacity = 1e9, .power = 100};
  const double calm = ways_home(scene, stages, task).ways.front().duration;
  task.energy->wind = 4;
  const double windy = ways_home(scene, stages, task).ways.front().duration;
  EXPECT_NEAR(windy - calm, (80 / 4.0 - 80 / 8.0), 1.5);
  task.energy->wind = 8;
  EXPECT_TRUE(support::says(support::refusal_of([&] { ways_home(scene, stages, task); }), "wind"));
}

// --- against an own simulation ------------------------------------------------------------------

bool touches(const geom::CollisionScene& scene, const Vec3& p) {
  const geom::Aabb& bounds = scene.map().spec().bounds;
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] - scene.half()[axis] < bounds.min[axis] - 1e-9) return true;
    if (p[axis] + scene.half()[axis] > bounds.max[axis] + 1e-9) return true;
  }
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const geom::Aabb box = scene.map().box(i);
    if (((p - scene.half()).array() <= box.max.array()).all() &&
        ((p + scene.half()).array() >= box.min.array()).all()) {
      return true;
    }
  }
  return false;
}

bool leg_touches(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b) {
  const int steps = 1 + static_cast<int>((b - a).norm() / 0.25);
  for (int i = 0; i <= steps; ++i) {
    if (touches(scene, a + (b - a) * (static_cast<double>(i) / steps))) return true;
  }
  return false;
}

// At a stop it goes on by what the model says.
bool overshoot_touches(const geom::CollisionScene& scene, const ReturnModel& model, const Vec3& a,
                       const Vec3& b) {
  const double over = model.overshoot_time * model.speed + model.overshoot;
  return leg_touches(scene, b, b + (b - a).normalized() * over);
}

// Where a vehicle that leaves the curve at that state may come to rest, by the model's own words:
// straight on, after the reaction at its speed and an S-curve, and what it overshoots.
Vec3 rest(const ReturnModel& model, const State& state, support::Random& random) {
  const double speed = state.velocity.head<2>().norm();
  const double straight = speed * model.reaction + speed * speed / (2 * model.deceleration) +
                          speed * model.deceleration / (2 * model.jerk);
  const double over = random.uniform(-1, 1) * (speed * model.overshoot_time);
  Vec3 out = state.position;
  if (speed > 0) {
    const double way = std::max(0.0, straight * random.uniform(0.3, 1) + over);
    out.head<2>() += state.velocity.head<2>() * (way / speed);
  }
  out.z() += state.velocity.z() * model.reaction * random.uniform(0, 1);
  return out;
}

Trajectory random_flight(support::Random& random) {
  Trajectory out;
  const auto somewhere = [&] {
    return Vec3(random.uniform(-70, 70), random.uniform(-70, 70), random.uniform(15, 90));
  };
  State state;
  state.position = somewhere();
  for (int i = 0; i < 3; ++i) {
    State next;
    next.position = state.position +
                    Vec3(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-8, 8));
    next.position.z() = std::clamp(next.position.z(), 5.0, 100.0);
    if (i < 2) next.velocity = Vec3(random.uniform(-6, 6), random.uniform(-6, 6), 0);
    out.segments.push_back(hermite(state, next, random.uniform(6, 12)));
    state = next;
  }
  return out;
}

TEST(WaysHome, NeverTouchAnythingWhereverTheVehicleLeaves) {
  int ways = 0;
  double covered = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    support::Random random(seed + 7000);
    const auto scene = small_vehicle(support::random_city(seed, 60, 150));
    WaysTask task;
    task.models = {testing::plain_model()};
    for (int i = 0; i < 20 && task.sites.size() < 3; ++i) {
      try {
        task.sites.push_back(landing_site(
            scene, testing::drawn_at(random.uniform(-120, 120), random.uniform(-120, 120)), "s"));
      } catch (const geom::InputError&) {  // there is no place to land
      }
    }
    const Trajectory flight = random_flight(random);
    const WaysHome home = ways_home(scene, stages_of(flight), task);
    covered += share(home);
    for (const WayHome& way : home.ways) {
      ++ways;
      for (std::size_t i = 1; i + 1 < way.points.size(); ++i) {
        ASSERT_FALSE(leg_touches(scene, way.points[i - 1], way.points[i])) << "seed " << seed;
        ASSERT_FALSE(overshoot_touches(scene, task.models[0], way.points[i - 1], way.points[i]));
      }
      for (int i = 0; i < 12; ++i) {
        const double t = random.uniform(way.from, way.until);
        const State state = evaluate(flight, t);
        const Vec3 end = rest(task.models[0], state, random);
        ASSERT_FALSE(leg_touches(scene, state.position, end)) << "seed " << seed << " at " << t;
        ASSERT_FALSE(leg_touches(scene, end, way.points.front())) << "seed " << seed << " at " << t;
        ASSERT_LE((end - way.points.front()).norm(), way.length) << "seed " << seed;
        ASSERT_FALSE(overshoot_touches(scene, task.models[0], end, way.points.front()));
      }
    }
  }
  EXPECT_GT(ways, 150);
  EXPECT_GT(covered, 40);
}

TEST(WaysHome, AreTheSameOnAnyNumberOfThreads) {
  const auto scene = small_vehicle(support::random_city(5, 60, 150));
  WaysTask task;
  task.models = {testing::plain_model()};
  task.sites = {landing_site(scene, testing::drawn_at(-130, -130), "s"),
                landing_site(scene, testing::drawn_at(130, 130), "s")};
  const auto lines = [&](unsigned threads) {
    std::vector<std::string> out(20);
    geom::parallel_for(out.size(), {threads, {}}, [&](std::size_t i) {
      support::Random random(i + 900);
      const WaysHome home = ways_home(scene, stages_of(random_flight(random)), task);
      for (const auto& record : contingency_records("q", home, task, {})) {
        out[i] += to_json_line(record);
      }
    });
    return out;
  };
  const auto one = lines(1);
  EXPECT_EQ(one, lines(2));
  EXPECT_EQ(one, lines(7));
}

}  // namespace
}  // namespace traj
