#include "traj/home/prism.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/random_city.h"

namespace traj {
namespace {

using geom::Aabb;
using support::Random;

// --- oracles in rationals -----------------------------------------------------------------------

using Exact = std::array<mpq_class, 2>;

Exact exact(const Vec2& p) { return {mpq_class(p.x()), mpq_class(p.y())}; }
Exact minus(const Exact& a, const Exact& b) { return {a[0] - b[0], a[1] - b[1]}; }
mpq_class cross(const Exact& a, const Exact& b) { return a[0] * b[1] - a[1] * b[0]; }
mpq_class dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1]; }

// Whether all `left` are strictly below all `right` along the axis, or all above.
bool separates(const Exact& axis, const std::vector<Exact>& left, const std::vector<Exact>& right) {
  const auto side = [&](const std::vector<Exact>& low, const std::vector<Exact>& high) {
    for (const Exact& a : low) {
      for (const Exact& b : high) {
        if (dot(axis, a) >= dot(axis, b)) return false;
      }
    }
    return true;
  };
  return side(left, right) || side(right, left);
}

// Of the closed hull of the points and a closed rectangle. One of them has the line that separates
// them along an edge; the lines through any two points are more than enough.
bool plans_meet(const std::vector<Vec2>& plan, const Aabb& box) {
  std::vector<Exact> points;
  for (const Vec2& p : plan) points.push_back(exact(p));
  std::vector<Exact> corners;
  for (const double x : {box.min.x(), box.max.x()}) {
    for (const double y : {box.min.y(), box.max.y()}) corners.push_back(exact({x, y}));
  }
  std::vector<Exact> axes{exact({1, 0}), exact({0, 1})};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      const Exact edge = minus(points[k], points[i]);
      axes.push_back({edge[1], -edge[0]});
      axes.push_back(edge);  // of hulls that are a line
    }
  }
  return std::none_of(axes.begin(), axes.end(),
                      [&](const Exact& axis) { return separates(axis, points, corners); });
}

bool truly_meets(const Prism& prism, const Aabb& box) {
  return prism.low <= box.max.z() && prism.high >= box.min.z() && plans_meet(prism.plan, box);
}

// --- cases --------------------------------------------------------------------------------------

// On a coarse lattice, so that much is aligned, touches or coincides; or anywhere.
Vec2 any_point(Random& random, bool lattice, const Vec2& about, double size) {
  if (lattice) {
    return about +
           Vec2(random.stepped(-size, size, size / 4), random.stepped(-size, size, size / 4));
  }
  return about + Vec2(random.uniform(-size, size), random.uniform(-size, size));
}

Prism any_prism(Random& random, bool lattice, const Vec2& about) {
  std::vector<Vec2> points;
  const double size = std::pow(10, random.below(4) - 1);
  for (int i = 1 + random.below(8); i > 0; --i) {
    points.push_back(any_point(random, lattice, about, size));
  }
  const double low = random.stepped(0, 4, 1);
  return {plan_hull(points), low, low + random.stepped(0, 4, 1)};
}

// Some of whose faces have a corner of the prism on them.
Aabb any_box(Random& random, const Prism& prism, bool lattice) {
  const Vec2& near =
      prism.plan[static_cast<std::size_t>(random.below(static_cast<int>(prism.plan.size())))];
  const Vec2& other =
      prism.plan[static_cast<std::size_t>(random.below(static_cast<int>(prism.plan.size())))];
  const Vec2 on_edge = random.below(2) ? near : Vec2(0.5 * (near + other));
  const double size = lattice ? 1 : random.uniform(0.01, 3);
  Aabb box;
  for (int i = 0; i < 2; ++i) {
    const double begin = on_edge[i] + (random.below(3) - 1) * size;
    box.min[i] = begin;
    box.max[i] = begin + size * random.below(3);
  }
  box.min.z() = random.stepped(0, 8, 1);
  box.max.z() = box.min.z() + random.stepped(0, 2, 1);
  return box;
}

TEST(PrismMeets, NeverCallsApartWhatMeets) {
  Random random(1);
  int met = 0;
  const int count = support::cases(20000);
  for (int i = 0; i < count; ++i) {
    const bool lattice = i % 2;
    const Vec2 about = i % 3 ? Vec2(0, 0) : Vec2(random.uniform(-1e6, 1e6), 4e5);
    const Prism prism = any_prism(random, lattice, about);
    const Aabb box = any_box(random, prism, lattice);
    if (!truly_meets(prism, box)) continue;
    ++met;
    ASSERT_TRUE(meets(prism, box)) << "case " << i;
  }
  EXPECT_GT(met, count / 10);  // else this test shows nothing
  EXPECT_LT(met, count * 9 / 10);
}

TEST(PrismMeets, CallsApartWhatIsAMicrometreApart) {
  Random random(2);
  int apart = 0;
  for (int i = 0; i < support::cases(10000); ++i) {
    const Prism prism = any_prism(random, i % 2, Vec2(random.uniform(-1e4, 1e4), 0));
    const Aabb box = any_box(random, prism, i % 2);
    const Vec3 hair = Vec3::Constant(1e-6);
    if (truly_meets(prism, {box.min - hair, box.max + hair})) continue;
    ++apart;
    ASSERT_FALSE(meets(prism, box)) << "case " << i;
  }
  EXPECT_GT(apart, 100);
}

TEST(PrismMeets, ClosedAtItsHeights) {
  const Prism square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1, 3};
  EXPECT_TRUE(meets(square, {{0.5, 0.5, 3}, {1, 1, 5}}));
  EXPECT_TRUE(meets(square, {{0.5, 0.5, 0}, {1, 1, 1}}));
  EXPECT_FALSE(meets(square, {{0.5, 0.5, std::nextafter(3, 4)}, {1, 1, 5}}));
  EXPECT_FALSE(meets(square, {{0.5, 0.5, 0}, {1, 1, std::nextafter(1, 0)}}));
}

TEST(PrismMeets, AColumnAndAWall) {
  EXPECT_TRUE(meets({{{1, 1}}, 0, 9}, {{1, 1, 4}, {2, 2, 5}}));
  EXPECT_FALSE(meets({{{1, 1}}, 0, 9}, {{1.001, 1, 4}, {2, 2, 5}}));
  const Prism wall{{{0, 0}, {10, 10}}, 0, 9};
  EXPECT_TRUE(meets(wall, {{5, 4, 4}, {6, 5, 5}}));  // touches its corner
  EXPECT_FALSE(meets(wall, {{5, 4, 4}, {6, 4.99, 5}}));
}

TEST(BoxesAround, HoldThePrismAndLittleElse) {
  Random random(5);
  for (int i = 0; i < support::cases(2000); ++i) {
    const Prism prism = any_prism(random, i % 2, Vec2(random.uniform(-1e4, 1e4), 0));
    const int parts = 1 + random.below(9);
    const std::vector<Aabb> boxes = boxes_around(prism, parts);
    ASSERT_LE(static_cast<int>(boxes.size()), parts);
    for (int k = 0; k < 40; ++k) {
      Vec2 p = Vec2::Zero();
      double sum = 0;
      for (const Vec2& corner : prism.plan) {
        const double weight = k % 4 ? random.uniform(0, 1) : random.below(2) + 1e-3;
        p += weight * corner;
        sum += weight;
      }
      p /= sum;
      const auto holds = [&](const Aabb& box) {
        return (p.array() >= box.min.head<2>().array() - 1e-9).all() &&
               (p.array() <= box.max.head<2>().array() + 1e-9).all() && box.min.z() == prism.low &&
               box.max.z() == prism.high;
      };
      ASSERT_TRUE(std::any_of(boxes.begin(), boxes.end(), holds)) << "case " << i;
    }
  }
  const Prism diagonal{{{0, 0}, {100, 99}, {100, 100}, {0, 1}}, 0, 1};
  double room = 0;
  for (const Aabb& box : boxes_around(diagonal, 10))
    room += (box.max - box.min).x() * (box.max - box.min).y();
  EXPECT_NEAR(room, 10 * 10 * 10.9, 1e-9);
}

// Whether p is in the hull of the corners, or so near that rounding explains it.
bool is_held(const std::vector<Vec2>& hull, const Vec2& p) {
  if (hull.size() == 1) return (hull[0] - p).norm() <= 1e-15 * p.norm();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Exact edge = minus(exact(hull[(i + 1) % hull.size()]), exact(hull[i]));
    const mpq_class aside = cross(edge, minus(exact(p), exact(hull[i])));
    const double size = std::max({1.0, p.norm(), hull[i].norm()});
    const double length = (hull[(i + 1) % hull.size()] - hull[i]).norm();
    if (aside.get_d() < -4e-15 * size * length) return false;
  }
  return true;
}

TEST(PlanHull, HoldsAllPointsAndIsCounterclockwise) {
  Random random(3);
  for (int i = 0; i < support::cases(3000); ++i) {
    std::vector<Vec2> points;
    for (int k = 1 + random.below(20); k > 0; --k) {
      points.push_back(any_point(random, i % 2, Vec2(i % 3 ? 0 : 1e5, 0), i % 5 ? 4 : 1e-6));
    }
    const std::vector<Vec2> hull = plan_hull(points);
    ASSERT_FALSE(hull.empty());
    for (const Vec2& p : points) ASSERT_TRUE(is_held(hull, p)) << "case " << i;
    for (const Vec2& p : hull) {
      ASSERT_NE(std::find(points.begin(), points.end(), p), points.end()) << "case " << i;
    }
  }
}

TEST(PlanHull, OfOnePlaceAndOfALine) {
  EXPECT_EQ(plan_hull({{1, 2}, {1, 2}, {1, 2}}).size(), 1u);
  const std::vector<Vec2> line = plan_hull({{0, 0}, {3, 3}, {1, 1}, {2, 2}});
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[0], Vec2(0, 0));
  EXPECT_EQ(line[1], Vec2(3, 3));
}

TEST(PrismAround, HoldsItsPointsAndNoMore) {
  const std::vector<Vec3> points{{0, 0, 5}, {4, 0, 1}, {0, 4, 9}, {1, 1, 3}};
  const Prism prism = prism_around(points);
  EXPECT_EQ(prism.low, 1);
  EXPECT_EQ(prism.high, 9);
  EXPECT_EQ(prism.plan.size(), 3u);
  const std::vector<Vec3> all = corners(prism);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].z(), 1);
  EXPECT_EQ(all[5].z(), 9);
}

// Distances of random points of the plan bound both from the right sides.
// Plans on a grid have parallel edges, lines and points, and sums without rounding.
TEST(PlanSum, IsTheHullOfAllSums) {
  Random random(6);
  for (int i = 0; i < support::cases(3000); ++i) {
    const bool grid = i % 2 == 0;
    const auto plan = [&] {
      std::vector<Vec2> points;
      for (int k = 1 + random.below(7); k > 0; --k) {
        points.emplace_back(grid ? Vec2(random.below(5), random.below(5))
                                 : Vec2(random.uniform(-1, 1), random.uniform(-1, 1)));
      }
      return plan_hull(std::move(points));
    };
    const std::vector<Vec2> a = plan();
    const std::vector<Vec2> b = plan();
    std::vector<Vec2> sums;
    for (const Vec2& p : a) {
      for (const Vec2& q : b) sums.push_back(p + q);
    }
    ASSERT_EQ(plan_sum(a, b), plan_hull(sums)) << "case " << i;
  }
}

TEST(PlanSum, KeepsTheEndsOfAllButParallelLines) {
  for (const double aside : {0.0, 1e-17, 1e-16, 1e-15, 1e-12}) {
    for (const Vec2& end : {Vec2(3, 1 + aside), Vec2(-3, 1 + aside), Vec2(aside, 2)}) {
      const auto sum = plan_sum(plan_hull({{0, 0}, {3, 1}}), plan_hull({{0, 0}, end}));
      const auto holds = [&](const Vec2& p) {
        return std::find(sum.begin(), sum.end(), p) != sum.end();
      };
      EXPECT_TRUE(holds(Vec2(3, 1) + end) || end.x() <= 0) << end.transpose();
      EXPECT_NEAR(furthest(sum, {0, 0}), furthest({{0, 0}, {3, 1}, end, Vec2(3, 1) + end}, {0, 0}),
                  1e-12);
      EXPECT_NEAR(furthest(sum, {9, 3}), furthest({{0, 0}, {3, 1}, end, Vec2(3, 1) + end}, {9, 3}),
                  1e-12);
    }
  }
}

TEST(PlanDistance, IsBetweenTheNearestAndTheFurthestPoint) {
  Random random(4);
  for (int i = 0; i < support::cases(500); ++i) {
    const Prism prism = any_prism(random, i % 2, {0, 0});
    const Vec2 p = any_point(random, i % 2, {0, 0}, 10);
    const double near = distance(prism.plan, p);
    const double far = furthest(prism.plan, p);
    double nearest = 1e9;
    for (int k = 0; k < 400; ++k) {
      Vec2 at = Vec2::Zero();
      double sum = 0;
      for (const Vec2& corner : prism.plan) {
        const double weight = std::pow(random.uniform(0, 1), k % 2 ? 1 : 8);
        at += weight * corner;
        sum += weight;
      }
      const double away = (at / sum - p).norm();
      ASSERT_GE(away, near - 1e-9) << "case " << i;
      ASSERT_LE(away, far + 1e-9) << "case " << i;
      nearest = std::min(nearest, away);
    }
    for (const Vec2& corner : prism.plan) {
      ASSERT_LE((corner - p).norm(), far + 1e-12);
      ASSERT_GE((corner - p).norm(), near - 1e-12);
    }
  }
}

TEST(PlanDistance, IsZeroInsideAndExactBeside) {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(distance(square, {1, 1}), 0);
  EXPECT_EQ(distance(square, {2, 1}), 0);
  EXPECT_EQ(distance(square, {5, 1}), 3);
  EXPECT_EQ(distance(square, {5, 6}), 5);
  EXPECT_EQ(furthest(square, {-1, 2}), std::hypot(3, 2));
  EXPECT_EQ(distance({{1, 1}}, {1, 4}), 3);
}

}  // namespace
}  // namespace traj
