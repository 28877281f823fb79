#include "traj/proof/sampled_flight.h"

#include <gtest/gtest.h>

#include <vector>

#include "geom/base/error.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

const geom::CollisionScene& wall() {
  static const geom::CollisionScene scene = scene_of({{Vec3(10, -5, 0), Vec3(11, 5, 20)}});
  return scene;
}

SampledFlight check(const std::vector<Vec3>& points, const std::vector<double>& times) {
  return check_sampled(wall(), points, times);
}

TEST(SampledFlight, IsSampledAtBest) {
  const SampledFlight flight = check({{0, 0, 5}, {4, 0, 5}, {8, 0, 5}, {4, 0, 5}}, {1, 2, 3, 4});
  EXPECT_EQ(verdict(flight), "sampled");
  EXPECT_EQ(flight.duration, 3);
  EXPECT_EQ(flight.longest_step, 1);
  EXPECT_NEAR(flight.clearance->value, 2, 1e-8);
  EXPECT_NEAR(flight.clearance->time, 3, 1e-12);
  EXPECT_EQ(flight.nearest, Vec3(8, 0, 5));
}

TEST(SampledFlight, SeesAWallBetweenTwoSamples) {
  const SampledFlight flight = check({{0, 0, 5}, {8, 0, 5}, {18, 0, 5}}, {0, 0.5, 1});
  EXPECT_EQ(verdict(flight), "collision");
  EXPECT_EQ(flight.box, 0u);
  EXPECT_GT(flight.time, 0.5 + 0.1 - 1e-6);
  EXPECT_LT(flight.time, 0.5 + 0.15 + 1e-6);
  EXPECT_NEAR(flight.place.x(), 8 + 20 * (flight.time - 0.5), 1e-6);
}

TEST(SampledFlight, ATouchIsACollision) {
  EXPECT_EQ(verdict(check({{0, 0, 5}, {10, 0, 5}}, {0, 1})), "collision");
  EXPECT_EQ(verdict(check({{9, 5, 5}, {12, 5, 5}}, {0, 1})), "collision");
}

TEST(SampledFlight, RefusesGaps) {
  const SampledFlight flight = check({{0, 0, 5}, {1, 0, 5}, {2, 0, 5}}, {0, 1, 2.5});
  EXPECT_EQ(verdict(flight), "gap");
  EXPECT_EQ(flight.time, 1);
  EXPECT_EQ(flight.place, Vec3(1, 0, 5));
  EXPECT_EQ(flight.worst, 1.5);
  EXPECT_EQ(flight.longest_step, 1.5);
}

TEST(SampledFlight, SaysNothingOfTheWayThroughAGap) {
  EXPECT_EQ(verdict(check({{0, 0, 5}, {20, 0, 5}}, {0, 1.01})), "gap");
}

TEST(SampledFlight, RefusesStepsThatNoVehicleFlies) {
  const SampledFlight flight = check({{0, 0, 5}, {1, 0, 5}, {4.1, 0, 5}}, {0, 0.1, 0.12});
  EXPECT_EQ(verdict(flight), "gap");
  EXPECT_EQ(flight.time, 0.1);
  EXPECT_EQ(verdict(check({{0, 0, 5}, {1, 0, 5}, {3.9, 0, 5}}, {0, 0.1, 0.12})), "sampled");
}

TEST(SampledFlight, SaysATouchRatherThanAGap) {
  const SampledFlight flight =
      check({{0, 0, 5}, {1, 0, 5}, {8, 0, 5}, {10.5, 0, 5}}, {0, 5, 5.5, 6});
  EXPECT_EQ(verdict(flight), "collision");
  EXPECT_FALSE(flight.gap);
  EXPECT_GT(flight.time, 5.5);
}

TEST(SampledFlight, RefusesTheBounds) {
  const SampledFlight flight = check({{0, 0, 5}, {0, 0, -1}}, {0, 1});
  EXPECT_EQ(verdict(flight), "bounds");
}

TEST(SampledFlight, SaysACollisionRatherThanTheBounds) {
  const SampledFlight flight =
      check({{0, 0, 5}, {0, 0, -3}, {0, 0, 5}, {10.5, 0, 5}}, {0, 1, 2, 3});
  EXPECT_EQ(verdict(flight), "collision");
  EXPECT_EQ(flight.box, 0u);
}

TEST(SampledFlight, StandsOnTheGroundBeforeAndAfter) {
  const double half = wall().half().z();
  const SampledFlight flight = check(
      {{0, 0, -0.1}, {0, 0, -0.2}, {0, 0, half + 1}, {5, 0, 5}, {5, 0, -0.1}}, {0, 1, 2, 3, 4});
  EXPECT_EQ(verdict(flight), "sampled");
  EXPECT_EQ(flight.on_ground, 3);
  EXPECT_EQ(verdict(check({{0, 0, 5}, {0, 0, -0.1}, {0, 0, 5}}, {0, 1, 2})), "bounds")
      << "in between it touches the ground";
  EXPECT_EQ(verdict(check({{0, 0, 5}, {0, 0, -0.6}}, {0, 1})), "bounds") << "no error of heights";
  EXPECT_EQ(verdict(check({{10.5, 0, -0.1}, {10.5, 0, 0.3}}, {0, 1})), "collision")
      << "inside a wall";
  EXPECT_EQ(verdict(check({{10.5, 0, 20}, {10.5, 0, 20.4}, {10.5, 0, 30}}, {0, 1, 2})), "sampled")
      << "on the wall";
}

TEST(SampledFlight, TakesOneSample) {
  EXPECT_EQ(verdict(check({{0, 0, 5}}, {3})), "sampled");
  EXPECT_EQ(verdict(check({{10.5, 0, 5}}, {3})), "collision");
  EXPECT_EQ(check({{10.5, 0, 5}}, {3}).time, 3);
}

TEST(SampledFlight, HasNoClearanceWithoutObstacles) {
  const geom::CollisionScene empty = scene_of({});
  EXPECT_FALSE(
      check_sampled(empty, std::vector<Vec3>{{0, 0, 5}}, std::vector<double>{0}).clearance);
}

TEST(SampledFlight, RefusesTimesThatDoNotGrow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> points = {{0, 0, 5}, {0, 0.1, 5}};
  for (const std::vector<double>& times : {std::vector<double>{0, nan}, {1, 0}, {0, 0}, {0}, {}}) {
    EXPECT_THROW(check_sampled(scene_of({}), points, times), geom::InputError);
  }
}

}  // namespace
}  // namespace traj
