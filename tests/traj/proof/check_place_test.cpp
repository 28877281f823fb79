#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"
#include "support/small_map.h"
#include "traj/proof/check.h"

namespace traj {
namespace {

using geom::CollisionScene;

constexpr int kSamples = 400;

// 40,000 posts of 20 m on a square of 1 km, but for 60 m around its middle.
CollisionScene posts() {
  std::vector<geom::Aabb> boxes;
  for (int x = -500; x < 500; x += 5) {
    for (int y = -500; y < 500; y += 5) {
      if (x * x + y * y > 3600) boxes.push_back({Vec3(x, y, 0), Vec3(x + 1, y + 1, 20)});
    }
  }
  return {
      support::map_of({{-2000, -2000, 0}, {2000, 2000, 2000}}, boxes), {"box", {0.5, 0.5, 0.5}}, 0};
}

// Away from the middle of the posts and back to it, some hundred metres out to both axes.
Trajectory swing(double climb) {
  const State out{{0, 0, 5}, {80, 80, climb}, Vec3::Zero(), Vec3::Zero()};
  const State back{{10, -10, 5}, {-80, -80, -climb}, Vec3::Zero(), Vec3::Zero()};
  return {{hermite(out, back, 20)}};
}

double depth_at(const CollisionScene& scene, const Vec3& p) {
  double most = -1e300;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const geom::Aabb box = scene.grown(i);
    most = std::max(most, std::min((p - box.min).minCoeff(), (box.max - p).minCoeff()));
  }
  return most;
}

// The check, and how many boxes meet the box around the curve's control points.
std::pair<CheckResult, std::size_t> checked(const CollisionScene& scene, const Trajectory& t) {
  return {check(scene, t, Limits{}),
          scene.boxes_meeting(*geom::bounds(t.segments[0].point)).size()};
}

TEST(CheckPlace, LooksAtWhatIsNearACurveThatSwingsFarOut) {
  const CollisionScene scene = posts();
  const auto [result, around] = checked(scene, swing(80));
  ASSERT_GT(around, 9000u);
  EXPECT_TRUE(result.ok) << name(result.reason);
  EXPECT_LT(result.looked_at, around / 5);
}

TEST(CheckPlace, ReportsACollisionFarOutWithoutLookingAtTheRest) {
  const CollisionScene scene = posts();
  const auto [result, around] = checked(scene, swing(0));
  ASSERT_GT(around, 9000u);
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_LT(result.looked_at, around / 2);
  ASSERT_TRUE(result.box);
  EXPECT_NEAR(depth_at(scene, result.place), result.worst, 1e-12);
}

geom::BoxMap crowd() { return support::random_city(61, 4000, 150); }

Trajectory curve_in(support::Random& random, double low, double high) {
  const auto state = [&](double speed) {
    const auto any = [&](double most) { return random.uniform(-most, most); };
    return State{{any(60), any(60), random.uniform(low, high)},
                 {any(speed), any(speed), any(speed / 4)},
                 {any(2), any(2), any(2)},
                 Vec3::Zero()};
  };
  const State middle = state(8);
  return {{hermite(state(0), middle, 4), hermite(middle, state(0), 4)}};
}

TEST(CheckPlace, ReportsTheDeepestPlaceAmongMany) {
  const CollisionScene scene(crowd(), {"box", {0.5, 0.5, 0.3}}, 0);
  support::Random random(62);
  for (int i = 0; i < 4; ++i) {
    const Trajectory t = curve_in(random, 5, 50);
    const CheckResult result = check(scene, t, Limits{});
    ASSERT_EQ(result.reason, Reason::collision) << "case " << i;
    double most = -1e300;
    double step = 0;
    Vec3 before = t.segments[0].point[0];
    for (int k = 0; k <= kSamples; ++k) {
      const Vec3 p = evaluate(t, duration(t) * k / kSamples).position;
      most = std::max(most, depth_at(scene, p));
      step = std::max(step, (p - before).norm());
      before = p;
    }
    EXPECT_GE(result.worst, most - 2e-6) << "case " << i;
    EXPECT_LE(result.worst, most + step) << "case " << i;
    EXPECT_NEAR(depth_at(scene, result.place), result.worst, 1e-12) << "case " << i;
    const geom::Aabb box = scene.grown(*result.box);
    const Vec3& p = result.place;
    EXPECT_NEAR(std::min((p - box.min).minCoeff(), (box.max - p).minCoeff()), result.worst, 1e-12);
  }
}

// The known touch, with more boxes around the curve than are looked at before it is cut.
TEST(CheckPlace, RejectsEveryCurveMovedIntoTouchAmongMany) {
  const CollisionScene scene(crowd(), {"box", {0.7, 0.7, 0.3}}, 0.2);
  support::Random random(64);
  int accepted = 0;
  int many = 0;
  for (int i = 0; accepted < 500; ++i) {
    const Trajectory t = curve_in(random, 80, 110);
    if (!check(scene, t, Limits{}).ok) continue;
    ++accepted;
    const Vec3 p = evaluate(t, random.uniform(0, duration(t))).position;
    const geom::Aabb box = scene.map().boxes()[static_cast<std::size_t>(random.below(4000))];
    Vec3 target = 0.5 * (box.min + box.max);
    const double depth = i % 3 ? random.uniform(0, 0.01) : 0;
    target.z() = box.max.z() + scene.half().z() - depth;
    Trajectory moved = t;
    for (Segment& s : moved.segments) {
      for (Vec3& q : s.point) q += target - p;
      many += scene.boxes_meeting(*geom::bounds(s.point)).size() > 64;
    }
    ASSERT_FALSE(check(scene, moved, Limits{}).ok) << "case " << i << ", depth " << depth;
  }
  EXPECT_GT(many, 250);
}

}  // namespace
}  // namespace traj
