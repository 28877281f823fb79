#include "traj/record/moving_obstacles.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "support/reading.h"
#include "traj/curve/trajectory.h"

namespace traj {
namespace {

constexpr const char* kEpoch = "2026-05-04T06:30:00Z";

// Two metres wide, at that place for a minute.
std::string crane(const std::string& id, double x, const std::string& epoch = kEpoch) {
  return fmt::format(
      R"({{"type":"moving","id":"{}","epoch":"{}","from":0,"until":60,"min":[{},-1,-1],)"
      R"("max":[{},1,1],"velocity":[0,0,0],"growth":[0,0,0]}})"
      "\n",
      id, epoch, x - 1, x + 1);
}

MovingObstacles read(const std::string& text) {
  std::istringstream in(text);
  return {in, "moving.jsonl"};
}

Trajectory along_x() {
  const Vec3 v(10, 0, 0);
  const Vec3 none = Vec3::Zero();
  return {{hermite({none, v, none, none}, {{100, 0, 0}, v, none, none}, 10)}};
}

TEST(MovingObstacles, RefusesAnIdTwiceAndTwoEpochs) {
  EXPECT_TRUE(support::says(support::refusal_of([] { read(crane("a", 5) + crane("a", 9)); }),
                            "\"a\" again"));
  const std::string two = crane("a", 5) + crane("b", 5, "2026-05-04T07:00:00Z");
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(two); }), "moving.jsonl:2"));
  EXPECT_EQ(read(crane("a", 5) + crane("b", 5)).count(), 2u);
}

TEST(MovingObstacles, FindsTheObstacleInTheWayAndProvesTheOther) {
  const MovingObstacles moving = read(crane("in the way", 50) + crane("behind", -50));
  const Trajectory trajectory = along_x();
  const std::vector<TimedFlight> flights = {{&trajectory, 0, {0.5, 0.5, 0.5}}};
  TogetherTask task;
  task.ids = {"q1"};
  task.epoch = kEpoch;
  task.rule.parked = Parked::gone;
  for (const unsigned threads : {1u, 3u}) {
    const auto found = moving.check(flights, task, 0, true, {threads, {}});
    ASSERT_EQ(found.conflicts.size(), 1u);
    EXPECT_EQ(found.conflicts[0].obstacle, "in the way");
    EXPECT_NEAR(found.conflicts[0].result.time, 5, 0.3);
    ASSERT_EQ(found.proved.size(), 1u);
    EXPECT_EQ(found.proved[0].obstacle, "behind");
    EXPECT_EQ(found.summary.refused, 1u);
    EXPECT_FALSE(found.summary.ok());
    EXPECT_EQ(found.claim.obstacles, (std::vector<std::string>{"in the way", "behind"}));
  }
}

TEST(MovingObstacles, AreNotClearOfAFlightThatWasLeftOut) {
  TogetherTask task;
  task.epoch = kEpoch;
  EXPECT_FALSE(read(crane("a", 5)).check({}, task, 1, false, {}).summary.ok());
}

TEST(MovingObstacles, RefuseFlightsOfAnotherEpoch) {
  TogetherTask task;
  task.epoch = "2026-05-05T06:30:00Z";
  EXPECT_NE(support::refusal_of([&] { read(crane("a", 5)).check({}, task, 1, false, {}); }), "");
}

}  // namespace
}  // namespace traj
