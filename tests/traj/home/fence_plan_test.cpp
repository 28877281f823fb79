#include "traj/home/fence_plan.h"

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "support/random_city.h"

namespace {

using geom::Aabb;
using geom::Vec2;
using geom::Vec3;
using support::Random;
using Q = CGAL::Gmpq;

const geom::GeodeticOrigin kOrigin{47.4, 8.5, 400};

geom::CollisionScene scene_of(std::vector<Aabb> boxes, geom::Axes axes = geom::Axes::enu) {
  const geom::Aabb bounds{{-3000, -3000, 0}, {3000, 3000, 200}};
  return {{{.frame = {axes}, .bounds = bounds}, support::table_of(std::move(boxes))},
          {"box", Vec3(0.5, 0.5, 0.25), {}},
          0.5};
}

traj::FenceTask task_of(std::vector<traj::FencedRegion> regions) {
  traj::FenceTask task;
  task.regions = std::move(regions);
  task.low = 50;
  task.high = 60;
  task.origin = kOrigin;
  return task;
}

traj::FencedRegion leg(const Vec2& a, const Vec2& b, double z = 50) {
  return {{{a.x(), a.y(), z}, {b.x(), b.y(), z}}, {1, 1}};
}

// --- in rationals
// ---------------------------------------------------------------------------------

struct Point {
  Q x;
  Q y;
};
using Ring = std::vector<Point>;

Q turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int sign(const Q& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; }

bool within(const Q& a, const Q& b, const Q& at) {
  return std::min(a, b) <= at && at <= std::max(a, b);
}

bool on_segment(const Point& p, const Point& a, const Point& b) {
  return turn(a, b, p) == 0 && within(a.x, b.x, p.x) && within(a.y, b.y, p.y);
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) {
    return true;
  }
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

// An odd number of edges to the right of a point that is on no edge.
bool is_inside(const Ring& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const int side = sign(turn(a, b, p));
    if (b.y > a.y ? side > 0 : side < 0) inside = !inside;
  }
  return inside;
}

// Whether a ring's line meets the convex hull of some points.
bool line_meets(const Ring& ring, const Ring& hull) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t a = 0; a < hull.size(); ++a) {
      for (std::size_t b = a; b < hull.size(); ++b) {
        if (meet(ring[i], ring[(i + 1) % ring.size()], hull[a], hull[b])) return true;
        for (std::size_t c = b + 1; c < hull.size(); ++c) {
          const int sides[] = {sign(turn(hull[a], hull[b], ring[i])),
                               sign(turn(hull[b], hull[c], ring[i])),
                               sign(turn(hull[c], hull[a], ring[i]))};
          const bool one = sides[0] > 0 && sides[1] > 0 && sides[2] > 0;
          if (one || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0)) return true;
        }
      }
    }
  }
  return false;
}

Ring ring_of(const traj::Fence& fence) {
  Ring ring;
  for (const Vec2& p : fence.ring) ring.push_back({Q(p.x()), Q(p.y())});
  return ring;
}

Ring corners_around(const Vec2& low, const Vec2& high) {
  return {{Q(low.x()), Q(low.y())},
          {Q(high.x()), Q(low.y())},
          {Q(high.x()), Q(high.y())},
          {Q(low.x()), Q(high.y())}};
}

bool is_kept_in(const traj::Fence& fence, const traj::FencedRegion& region) {
  const Ring ring = ring_of(fence);
  Ring hull;
  for (const Vec3& p : region.hull) {
    for (const Point& corner :
         corners_around(p.head<2>() - region.room, p.head<2>() + region.room)) {
      hull.push_back(corner);
    }
  }
  return !line_meets(ring, hull) && is_inside(ring, hull.front()) == fence.inclusion;
}

bool is_kept_out(const traj::Fence& fence, const Aabb& box) {
  const Ring ring = ring_of(fence);
  const Ring plan = corners_around(box.min.head<2>(), box.max.head<2>());
  return !line_meets(ring, plan) && is_inside(ring, plan.front()) != fence.inclusion;
}

// Everything that compile_fences() says, by other means. False: it found none.
bool proved(const geom::CollisionScene& scene, const traj::FenceTask& task,
            const traj::CompiledFences& made) {
  EXPECT_EQ(made.missing.empty(), !made.fences.empty());
  if (!made.missing.empty()) return false;
  EXPECT_LE(made.corners, task.budget);
  std::vector<traj::Fence> fences;
  std::size_t corners = 0;
  for (const traj::GeodeticFence& one : made.fences) {
    corners += one.ring.size();
    for (const geom::GeodeticPlace& p : one.ring) {
      EXPECT_NEAR(p.latitude * 1e7, std::round(p.latitude * 1e7), 1e-3);
      EXPECT_NEAR(p.longitude * 1e7, std::round(p.longitude * 1e7), 1e-3);
    }
    fences.push_back(traj::fence_on_map(one, task.origin, "compiled"));
    for (Vec2& p : fences.back().ring) {
      p = geom::to_enu(scene.map().spec().frame.axes, Vec3(p.x(), p.y(), 0)).head<2>();
    }
  }
  EXPECT_EQ(corners, made.corners);
  for (const traj::Fence& fence : fences) {
    for (const traj::FencedRegion& region : task.regions) EXPECT_TRUE(is_kept_in(fence, region));
  }
  const double reach = scene.half().z();
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const Aabb box = scene.map().box(i);
    if (box.max.z() + reach < task.low || box.min.z() - reach > task.high) continue;
    if (std::binary_search(made.open.begin(), made.open.end(), i)) continue;
    EXPECT_TRUE(std::any_of(fences.begin(), fences.end(),
                            [&](const traj::Fence& fence) { return is_kept_out(fence, box); }))
        << "box " << i;
  }
  return true;
}

// --- random towns
// -----------------------------------------------------------------------------------

std::vector<Aabb> town(Random& random, int houses) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < houses; ++i) {
    const Vec2 at(random.uniform(-200, 200), random.uniform(-200, 200));
    const Vec2 size(random.uniform(2, 40), random.uniform(2, 40));
    boxes.push_back(
        {{at.x(), at.y(), 0}, {at.x() + size.x(), at.y() + size.y(), random.uniform(10, 90)}});
  }
  return boxes;
}

bool is_near(const Aabb& box, const traj::FencedRegion& region, double by) {
  const Ring plan = corners_around(box.min.head<2>() - Vec2::Constant(by),
                                   box.max.head<2>() + Vec2::Constant(by));
  Ring hull;
  for (const Vec3& p : region.hull) {
    for (const Point& corner :
         corners_around(p.head<2>() - region.room, p.head<2>() + region.room)) {
      hull.push_back(corner);
    }
  }
  return line_meets(plan, hull) || is_inside(plan, hull.front());
}

// Legs in a row and a triangle, where they are clear of the tall boxes; some are not.
std::vector<traj::FencedRegion> way(Random& random, const std::vector<Aabb>& boxes) {
  std::vector<traj::FencedRegion> regions;
  Vec2 at(random.uniform(-150, 150), random.uniform(-150, 150));
  for (int tries = 0; regions.size() < 8 && tries < 200; ++tries) {
    const Vec2 next = at + Vec2(random.uniform(-120, 120), random.uniform(-120, 120));
    traj::FencedRegion region = leg(at, next);
    if (random.below(4) == 0) {
      const Vec2 third = at + Vec2(random.uniform(-60, 60), random.uniform(-60, 60));
      region.hull.push_back({third.x(), third.y(), 55});
    }
    const bool clear = std::none_of(boxes.begin(), boxes.end(), [&](const Aabb& box) {
      return box.max.z() > 49 && is_near(box, region, 0.03);
    });
    if (!clear && random.below(60) != 0) continue;
    regions.push_back(region);
    at = next;
  }
  if (regions.empty()) regions.push_back(leg(at, at));
  return regions;
}

// --- cases
// --------------------------------------------------------------------------------------------

TEST(CompileFences, NeedFourCornersWhereNothingStands) {
  const auto scene = scene_of({});
  const auto task = task_of({leg({0, 0}, {80, 30})});
  const auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(proved(scene, task, made)) << made.missing;
  EXPECT_EQ(made.fences.size(), 1u);
  EXPECT_LE(made.corners, 4u);
  EXPECT_TRUE(made.open.empty());
}

TEST(CompileFences, LeaveOutATowerBetweenTwoLegs) {
  const auto scene = scene_of({{{45, -5, 0}, {55, 5, 80}}, {{20, 40, 0}, {30, 50, 20}}});
  const auto task = task_of({leg({0, -30}, {100, -30}), leg({100, -30}, {100, 30}),
                             leg({100, 30}, {0, 30}), leg({0, 30}, {0, -30})});
  const auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(proved(scene, task, made)) << made.missing;
  ASSERT_EQ(made.fences.size(), 2u);
  EXPECT_TRUE(made.fences[0].inclusion);
  EXPECT_FALSE(made.fences[1].inclusion);
  EXPECT_LE(made.corners, 8u);
}

TEST(CompileFences, SayWhichBoxesARegionPassesOver) {
  const auto scene = scene_of({{{45, -5, 0}, {55, 5, 52}}, {{45, 40, 0}, {55, 50, 80}}});
  const auto task = task_of({leg({0, 0}, {100, 0}, 58)});
  const auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(proved(scene, task, made)) << made.missing;
  EXPECT_EQ(made.open, std::vector<std::size_t>{0});
}

TEST(CompileFences, KeepABudget) {
  const auto scene = scene_of({{{45, -5, 0}, {55, 5, 80}}});
  auto task = task_of({leg({0, -30}, {100, -30}), leg({100, -30}, {100, 30}),
                       leg({100, 30}, {0, 30}), leg({0, 30}, {0, -30})});
  task.budget = 5;
  const auto made = traj::compile_fences(scene, task);
  EXPECT_FALSE(proved(scene, task, made));
  EXPECT_GT(made.corners, 5u);
  EXPECT_NE(made.missing.find("corners were needed"), std::string::npos);
}

TEST(CompileFences, RefuseRegionsThatAWallKeepsApart) {
  const auto scene = scene_of({{{-3000, 10, 0}, {3000, 12, 80}}});
  const auto made =
      traj::compile_fences(scene, task_of({leg({0, 0}, {5, 0}), leg({0, 30}, {5, 30})}));
  EXPECT_TRUE(made.fences.empty());
  EXPECT_NE(made.missing.find("apart"), std::string::npos);
}

TEST(CompileFences, LieBetweenARegionAndABoxFourCentimetresAway) {
  const auto scene = scene_of({{{10, 1.04, 0}, {60, 30, 80}}, {{20, -30, 0}, {30, -1.04, 80}}});
  const auto task = task_of({leg({0, 0}, {100, 0})});
  const auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(proved(scene, task, made)) << made.missing;
  EXPECT_TRUE(made.open.empty());
}

TEST(CompileFences, HoldOnMapsWithNorthFirst) {
  const auto scene = scene_of({{{45, -5, 0}, {55, 5, 80}}}, geom::Axes::neu);
  const auto task = task_of({leg({0, -30}, {100, -30}), leg({100, -30}, {100, 40})});
  const auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(proved(scene, task, made)) << made.missing;
}

TEST(CompileFences, DoWhatTheySayInRandomTowns) {
  int found = 0;
  std::size_t open = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<Aabb> boxes = town(random, random.below(60));
    const auto scene = scene_of(boxes, seed % 3 == 0 ? geom::Axes::neu : geom::Axes::enu);
    auto task = task_of(way(random, boxes));
    const auto made = traj::compile_fences(scene, task);
    found += proved(scene, task, made);
    open += made.open.size();
    for (const std::size_t box : made.open) {
      EXPECT_TRUE(std::any_of(
          task.regions.begin(), task.regions.end(),
          [&](const auto& region) { return is_near(scene.map().box(box), region, 0.02); }))
          << "box " << box << " is far from all regions";
    }
  }
  EXPECT_GE(found, 55);
  EXPECT_GT(open, 0u);
}

TEST(CompileFences, AreTheSameEachTime) {
  Random random(7);
  const std::vector<Aabb> boxes = town(random, 50);
  const auto scene = scene_of(boxes);
  const auto task = task_of(way(random, boxes));
  const auto one = traj::compile_fences(scene, task);
  const auto other = traj::compile_fences(scene, task);
  ASSERT_EQ(one.fences.size(), other.fences.size());
  for (std::size_t i = 0; i < one.fences.size(); ++i) {
    EXPECT_EQ(one.fences[i].ring, other.fences[i].ring);
  }
}

TEST(WhyNotFenced, SaysWhatIsWrong) {
  const auto scene = scene_of({{{45, 5, 0}, {55, 15, 80}}});
  const auto task = task_of({leg({0, 0}, {100, 0})});
  auto made = traj::compile_fences(scene, task);
  ASSERT_TRUE(made.missing.empty()) << made.missing;
  EXPECT_FALSE(traj::why_not_fenced(scene, task, made.fences, {}, "f"));
  auto wider = task;
  wider.regions.front().room = {60, 60};
  EXPECT_NE(traj::why_not_fenced(scene, wider, made.fences, {}, "f")->find("region 0"),
            std::string::npos);
  const geom::GeographicFrame earth(kOrigin);
  traj::GeodeticFence all{.inclusion = true};
  for (const Vec2& p : {Vec2(-50, -50), Vec2(150, -50), Vec2(150, 50), Vec2(-50, 50)}) {
    all.ring.push_back(earth.place({p.x(), p.y(), 0}));
  }
  EXPECT_NE(traj::why_not_fenced(scene, task, {{all}}, {}, "f")->find("box 0"), std::string::npos);
  const std::size_t open[] = {0};
  EXPECT_FALSE(traj::why_not_fenced(scene, task, {{all}}, open, "f"));
  EXPECT_TRUE(traj::why_not_fenced(scene, task, {}, {}, "f"));
}

TEST(WhyNotFenced, CountsABoxThatIsPartlyFencedAsNotFenced) {
  const auto scene = scene_of({{{45, 45, 0}, {55, 55, 80}}});
  const auto task = task_of({leg({0, 0}, {20, 0})});
  const geom::GeographicFrame earth(kOrigin);
  traj::GeodeticFence across{.inclusion = true};
  for (const Vec2& p : {Vec2(-50, -50), Vec2(150, -50), Vec2(150, 50), Vec2(-50, 50)}) {
    across.ring.push_back(earth.place({p.x(), p.y(), 0}));
  }
  EXPECT_TRUE(traj::why_not_fenced(scene, task, {{across}}, {}, "f"));
}

TEST(FenceBudget, IsWhatTheAutopilotsStore) {
  EXPECT_EQ(traj::fence_budget(*traj::autopilots_of("any")), 63u);
  EXPECT_EQ(traj::fence_budget(*traj::autopilots_of("px4:1.14")), 63u);
  EXPECT_EQ(traj::fence_budget(*traj::autopilots_of("px4:1.15")), 64u);
  EXPECT_EQ(traj::fence_budget(*traj::autopilots_of("ardupilot")), 70u);
}

TEST(CornersOf, CountsACircleOnce) {
  EXPECT_EQ(traj::corners_of({{{true, {}, {47, 8, 0}, 30}, {false, {{}, {}, {}}, {}, 0}}}), 4u);
}

}  // namespace
