#include "path/taut.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan/planner/plan.h"
#include "plan/scenes.h"
#include "support/random_city.h"

namespace plan {
namespace {

TEST(Taut, IsNeverLongerAndEveryLegIsFree) {
  const auto scene = small_city(4);
  Planner planner(scene, nullptr);
  support::Random random(4);
  int tried = 0;
  while (tried < 60) {
    const Vec3 from(random.uniform(-150, 150), random.uniform(-150, 150), random.uniform(1, 40));
    const Vec3 to(random.uniform(-150, 150), random.uniform(-150, 150), random.uniform(1, 40));
    PlanOptions options;
    options.raw = true;
    const PlanResult raw = planner.plan(from, to, options);
    if (raw.status != PathStatus::found || raw.path.size() < 3) continue;
    ++tried;
    const geom::Polyline path = taut(scene, raw.path);
    EXPECT_LE(geom::length(path), geom::length(raw.path) + 1e-9);
    EXPECT_EQ(path.front(), from);
    EXPECT_EQ(path.back(), to);
    for (std::size_t i = 1; i < path.size(); ++i) {
      ASSERT_TRUE(scene.free(path[i - 1], path[i]));
    }
  }
}

void expect_free(const geom::CollisionScene& scene, const geom::Polyline& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(scene.free(path[i - 1], path[i])) << "leg " << i - 1;
  }
}

// Pulled to the two edges of a pillar that is too high to go over; a millimetre stays between.
TEST(Taut, LeadsFromEdgeToEdgeOfWhatItGoesRound) {
  const auto scene = scene_of({{{4, -2, 0}, {6, 2, 90}}}, {{-20, -20, 0}, {20, 20, 100}});
  const geom::Polyline path = taut(scene, {{0, 0, 5}, {5, 10, 9}, {10, 0, 5}});
  expect_free(scene, path);
  const double shortest = 2 * std::hypot(4.0, 2.0) + 2;
  EXPECT_GE(geom::length(path), shortest);
  EXPECT_LE(geom::length(path), shortest + 0.01);
}

// Over 400 m, with a small pillar far from all bends.
TEST(Taut, GoesRoundAllThatStandsAlongALongLeg) {
  const auto scene = scene_of({{{190, -10, 0}, {210, 30, 90}}, {{60, 5, 0}, {62, 12, 90}}},
                              {{-20, -20, 0}, {420, 220, 100}});
  const geom::Polyline path = taut(scene, {{0, 0, 5}, {200, 120, 5}, {400, 0, 5}});
  expect_free(scene, path);
  const double shortest =
      std::hypot(60.0, 12.0) + std::hypot(130.0, 18.0) + 20 + std::hypot(190.0, 30.0);
  EXPECT_GE(geom::length(path), shortest);
  EXPECT_LE(geom::length(path), shortest + 0.01);
}

TEST(Taut, IsTheStraightLineWhereNothingStandsBetween) {
  const auto scene = scene_of({{{4, -2, 0}, {6, 2, 90}}}, {{-20, -20, 0}, {20, 20, 100}});
  EXPECT_EQ(taut(scene, {{0, 9, 5}, {10, 9, 5}}), (geom::Polyline{{0, 9, 5}, {10, 9, 5}}));
  const geom::Polyline bent = taut(scene, {{0, 9, 5}, {5, 15, 9}, {10, 9, 5}});
  EXPECT_NEAR(geom::length(bent), 10, 1e-3);
}

TEST(Taut, StaysOnTheSideItGoesRound) {
  const auto scene = scene_of({{{4, -2, 0}, {6, 12, 90}}}, {{-20, -20, 0}, {20, 20, 100}});
  const geom::Polyline path = taut(scene, {{0, 0, 5}, {5, 18, 5}, {10, 0, 5}});
  expect_free(scene, path);
  EXPECT_NEAR(geom::length(path), 2 * std::hypot(4.0, 12.0) + 2, 0.01) << "not the short way";
}

}  // namespace
}  // namespace plan
