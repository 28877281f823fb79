#include "mission/flown/flown_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "geom/shape/hull.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using std::numbers::pi;
using testing::Random;

bool holds(const Hull& hull, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(1e-9);
  return geom::hull_meets(hull, {p - hair, p + hair}).has_value();
}

TEST(BeforeCorner, IsNoFurtherBackThanTheLeg) {
  EXPECT_EQ(before_corner({0, 0, 0}, {10, 0, 0}, 4), Vec3(6, 0, 0));
  EXPECT_EQ(before_corner({0, 0, 0}, {10, 0, 0}, 40), Vec3(0, 0, 0));
  EXPECT_EQ(before_corner({1, 2, 3}, {1, 2, 3}, 4), Vec3(1, 2, 3));
}

TEST(CornerHull, HoldsEveryShortCutAndTheBraking) {
  const Vec3 from(0, 0, 10);
  const Vec3 corner(50, 0, 10);
  const Vec3 to(50, 60, 20);
  const Hull hull = corner_hull(from, corner, to, 8, 3);
  for (double s = 0; s <= 1; s += 0.125) {
    for (double t = 0; t <= 1; t += 0.125) {
      const Vec3 a = before_corner(from, corner, 8 * s);
      const Vec3 b = before_corner(to, corner, 8 * t);
      EXPECT_TRUE(holds(hull, a));
      EXPECT_TRUE(holds(hull, b));
      EXPECT_TRUE(holds(hull, 0.5 * (a + b)));
    }
  }
  EXPECT_TRUE(holds(hull, {53, 0, 10}));
  EXPECT_FALSE(holds(hull, {53.1, 0, 10}));
  EXPECT_FALSE(holds(hull, {41.9, 0, 10}));
  EXPECT_FALSE(holds(corner_hull(from, corner, to, 8, 0), {50.1, 0, 10}));
}

// The curve by its own equations: a cubic from two places and two velocities.
Vec3 cubic(const Vec3& a, const Vec3& b, const Vec3& v, const Vec3& w, double t) {
  return a + v * t + (-3 * a - 2 * v + 3 * b - w) * t * t + (2 * a + v - 2 * b + w) * t * t * t;
}

TEST(SplineHull, HoldsEverySplineOfTheVelocitiesThatMayBe) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = random.vector(50);
    const Vec3 b = random.vector(50);
    const std::vector<Vec3> leaving = {random.vector(200), random.vector(200)};
    const std::vector<Vec3> arriving = {random.vector(200), random.vector(20)};
    const Hull hull = spline_hull(a, b, leaving, arriving);
    for (const Vec3& v : {leaving[0], leaving[1], Vec3(Vec3::Zero())}) {
      for (const Vec3& w : {arriving[0], arriving[1], Vec3(Vec3::Zero())}) {
        const double sum = v.norm() + w.norm();
        const double scale = sum > 0 ? std::min(1.0, 4 * (b - a).norm() / sum) : 1;
        for (double t = 0; t <= 1; t += 0.0625) {
          ASSERT_TRUE(holds(hull, cubic(a, b, scale * v, scale * w, t))) << "case " << i;
        }
      }
    }
  }
}

TEST(Circle, HoldsItsArcsClosely) {
  const Circle circle{{3, -2, 7}, 25};
  for (const double from : {-3.0, 0.0, 1.5, 3.1}) {
    for (const double wide : {1e-9, 0.1, 1.0, -2.5, 3.3, pi / 16}) {
      const Hull hull = circle.arc(from, wide);
      for (double t = 0; t <= 1; t += 0.03125) {
        EXPECT_TRUE(holds(hull, circle.at(from + t * wide))) << from << ' ' << wide;
      }
      for (const Vec3& p : hull) EXPECT_LT((p - circle.centre).norm(), 25 * 1.005);
      EXPECT_FALSE(holds(hull, circle.at(from - std::copysign(0.01, wide))));
    }
  }
  EXPECT_NEAR(circle.angle_to(circle.at(2)), 2, 1e-12);
}

TEST(FlyCircle, HasRoomWhereItBegins) {
  const Circle circle{{3, -2, 7}, 25};
  const Vec3 outside = circle.centre + Vec3(60, 0, -2);
  const CircleFlight flight = fly_circle(circle, {circle.centre + Vec3(70, 10, -2), outside});
  ASSERT_EQ(flight.points.size(), 33u);
  EXPECT_LT((flight.points.front() - circle.at(0)).norm(), 1e-9);
  EXPECT_LT((flight.points.back() - circle.at(0)).norm(), 1e-9);
  const double first = std::atan2(10, 70);
  const double room = 0.04 / circle.radius;
  for (const Hull& hull : {flight.entry, flight.leaving}) {
    for (const double angle : {-room, 0.0, first / 2, first + room}) {
      EXPECT_TRUE(holds(hull, circle.at(angle))) << angle;
    }
    EXPECT_FALSE(holds(hull, circle.at(-2 * room)));
  }
  EXPECT_TRUE(holds(flight.entry, outside));
  EXPECT_FALSE(holds(flight.leaving, outside));
  for (double angle = 0; angle < 6.3; angle += 0.01) {
    EXPECT_TRUE(std::any_of(flight.arcs.begin(), flight.arcs.end(),
                            [&](const Hull& arc) { return holds(arc, circle.at(angle)); }));
  }
}

TEST(ReturnHulls, HoldTheClimbAndTheWayAcross) {
  const Hull low{{200, 0, 20}, {200, 5, 20}};
  const auto far = return_hulls(low, {0, 0, 60}, 10, 1);
  ASSERT_EQ(far.size(), 2u);
  EXPECT_TRUE(holds(far[0], {200, 3, 45}));
  EXPECT_TRUE(holds(far[1], {100, 1, 60}));
  EXPECT_FALSE(holds(far[1], {100, 1, 55}));
}

TEST(ReturnHulls, HoldAllHeightsFromNear) {
  const auto near = return_hulls({{40, 0, 20}}, {0, 0, 60}, 10, 1);
  EXPECT_TRUE(holds(near[1], {20, 0, 20}));
  EXPECT_TRUE(holds(near[1], {1, 0, 59}));
  EXPECT_FALSE(holds(near[1], {20, 0, 19}));
  const Hull further{{90, 0, 20}};
  EXPECT_FALSE(holds(return_hulls(further, {0, 0, 60}, 10, 1)[1], {45, 0, 40}));
  EXPECT_TRUE(holds(return_hulls(further, {0, 0, 60}, 10, 0.5)[1], {45, 0, 40})) << "a low cone";
  EXPECT_FALSE(holds(return_hulls({{40, 0, 20}}, {0, 0, 60}, 10, 0)[1], {20, 0, 40})) << "none";
}

TEST(Circle, HoldsItsDisc) {
  const Circle circle{{3, -2, 7}, 25};
  const Hull disc = circle.disc();
  for (double angle = 0; angle < 7; angle += 0.01) EXPECT_TRUE(holds(disc, circle.at(angle)));
  EXPECT_TRUE(holds(disc, circle.centre));
  EXPECT_FALSE(holds(disc, circle.centre + Vec3(25.2, 0, 0)));
}

}  // namespace
}  // namespace traj
