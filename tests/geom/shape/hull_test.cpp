#include "geom/shape/hull.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <vector>

#include "geom/base/error.h"
#include "support/failing_memory.h"
#include "support/random_city.h"

namespace geom {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 exact(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

// By CGAL's exact kernel; `points` are 1 to 4.
bool meets_exactly(const std::vector<Vec3>& points, const Aabb& box) {
  const Kernel::Iso_cuboid_3 cuboid(exact(box.min), exact(box.max));
  for (const Vec3& p : points) {
    if (cuboid.has_on_bounded_side(exact(p)) || cuboid.has_on_boundary(exact(p))) return true;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (segment_hits(points[i], points[j], box)) return true;
      for (std::size_t k = 0; k < j; ++k) {
        const Kernel::Triangle_3 triangle(exact(points[i]), exact(points[j]), exact(points[k]));
        if (!triangle.is_degenerate() && CGAL::do_intersect(triangle, cuboid)) return true;
      }
    }
  }
  if (points.size() < 4) return false;
  const Kernel::Tetrahedron_3 solid(exact(points[0]), exact(points[1]), exact(points[2]),
                                    exact(points[3]));
  return !solid.is_degenerate() && !solid.has_on_unbounded_side(exact(box.min));
}

// On a grid, so that points, edges and faces often just touch.
Vec3 on_grid(support::Random& random, double step) {
  const auto one = [&] { return step * std::round(random.uniform(-6, 6)); };
  const double x = one();
  const double y = one();
  return {x, y, one()};
}

TEST(HullMeets, NeverMissesWhatMeetsExactly) {
  support::Random random(1);
  int meeting = 0;
  int apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const double step = i % 2 ? 1 : 0.1;
    std::vector<Vec3> points;
    for (int n = 0; n <= i % 4; ++n) points.push_back(on_grid(random, step));
    const Vec3 a = on_grid(random, step);
    const Vec3 b = on_grid(random, step);
    const Aabb box{a.cwiseMin(b), a.cwiseMax(b)};
    const bool said = hull_meets(points, box).has_value();
    if (meets_exactly(points, box)) {
      ++meeting;
      ASSERT_TRUE(said) << "case " << i;
    } else {
      ++apart;
      // Of a grid of whole numbers, what is apart is further apart than rounding; on tenths, what
      // touches but for rounding may count as touching.
      if (step == 1) {
        EXPECT_FALSE(said) << "case " << i;
      }
    }
  }
  EXPECT_GT(meeting, 5000);
  EXPECT_GT(apart, 2000);
}

// Points and a box that take several steps and drop some of what they looked at.
struct Room {
  std::vector<Vec3> points;
  Aabb box;
};

Room some_room(support::Random& random) {
  const auto point = [&] {
    return Vec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
  };
  Room room;
  for (int n = 0; n < 6; ++n) room.points.push_back(point());
  const Vec3 a = point();
  const Vec3 b = point();
  room.box = {a.cwiseMin(b), a.cwiseMax(b)};
  return room;
}

TEST(HullMeets, IsNotChangedByAFailedAllocation) {
  support::Random random(4);
  int failures = 0;
  for (int i = 0; i < 300; ++i) {
    const Room room = some_room(random);
    const auto right = hull_meets(room.points, room.box);
    for (int n = 0;; ++n) {
      try {
        const support::FailingMemory memory(n, support::FailingMemory::Then::works);
        EXPECT_EQ(hull_meets(room.points, room.box), right) << "case " << i;
      } catch (const std::bad_alloc&) {
      }
      if (!support::FailingMemory::any_failed()) break;
      ++failures;
    }
  }
  EXPECT_GT(failures, 1000);
}

TEST(HullMeets, TellsAMicrometreFarFromTheOrigin) {
  const Vec3 far(1e5, -2e5, 300);
  const std::vector<Vec3> triangle = {far, far + Vec3(10, 0, 0), far + Vec3(0, 10, 0)};
  const Vec3 beyond = far + Vec3(5, 5, 0);  // on the middle of the long edge
  const Aabb apart{beyond + Vec3(1e-6, 1e-6, -1), beyond + Vec3(1, 1, 1)};
  const Aabb meeting{beyond + Vec3(-1e-6, -1e-6, -1), beyond + Vec3(1, 1, 1)};
  EXPECT_FALSE(hull_meets(triangle, apart));
  EXPECT_TRUE(hull_meets(triangle, meeting));
}

TEST(HullMeets, SaysWhere) {
  support::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3> points;
    for (int n = 0; n < 12; ++n) points.push_back(on_grid(random, 1));
    const Vec3 a = on_grid(random, 1);
    const Aabb box{a, a + Vec3(1, 2, 3)};
    const auto place = hull_meets(points, box);
    if (!place) continue;
    EXPECT_LT((place->cwiseMax(box.min).cwiseMin(box.max) - *place).norm(), 1e-9) << "case " << i;
    EXPECT_TRUE(hull_meets(points, {*place, *place})) << "case " << i;
  }
}

TEST(HullDepth, IsHowFarTheFacesCanMoveInwards) {
  const std::vector<Vec3> triangle = {{-10, 0, 5}, {3, -9, 5}, {3, 9, 5}};
  const HullDepth deep = hull_depth(triangle, {{0, -4, 0}, {20, 4, 20}});
  EXPECT_NEAR(deep.depth, 3, 1e-6);
  EXPECT_NEAR(deep.place.x(), 3, 1e-6);
  EXPECT_NEAR(hull_depth(triangle, {{3, -4, 0}, {20, 4, 20}}).depth, 0, 1e-6);
  EXPECT_EQ(hull_depth(triangle, {{4, -4, 0}, {20, 4, 20}}).depth, 0);
}

TEST(HullMeets, RefusesWhatIsNoPoint) {
  const std::vector<Vec3> points = {{std::numeric_limits<double>::quiet_NaN(), 0, 0}};
  EXPECT_THROW(hull_meets(points, {{0, 0, 0}, {1, 1, 1}}), InputError);
  EXPECT_THROW(hull_meets(std::vector<Vec3>{{0, 0, 0}}, {{0, 0, 0}, {1e300, 1, 1}}), InputError);
}

}  // namespace
}  // namespace geom
