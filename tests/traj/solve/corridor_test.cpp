#include "traj/solve/corridor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/segment_distance.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// Up to that wide and high, in a cube of 120 m that stands on the ground.
std::vector<geom::Aabb> boxes_in_the_air(testing::Random& random, int count, double width,
                                         double height) {
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = random.vector(60) + Vec3(0, 0, 60);
    const Vec3 size(random.number(0, width), random.number(0, width), random.number(0, height));
    boxes.push_back({p, p + size});
  }
  return boxes;
}

TEST(Joints, CutLegsNearCornersAndAtRest) {
  EXPECT_EQ(joints({Vec3::Zero(), Vec3(8, 0, 0)}),
            (geom::Polyline{Vec3::Zero(), Vec3(2, 0, 0), Vec3(6, 0, 0), Vec3(8, 0, 0)}));
  const geom::Polyline longer = joints({Vec3::Zero(), Vec3(100, 0, 0)});
  std::vector<double> x;
  for (const Vec3& p : longer) x.push_back(p.x());
  EXPECT_EQ(x, (std::vector<double>{0, 2, 8, 36, 64, 92, 98, 100}));
}

TEST(Joints, KeepThePathsOwnPointsAndDropRepeatedOnes) {
  const geom::Polyline path{Vec3::Zero(), Vec3(15, 0.1, 0), Vec3(15, 0.1, 0), Vec3(15, 70.3, 7)};
  const geom::Polyline got = joints(path);
  for (const Vec3& p : path) EXPECT_EQ(std::count(got.begin(), got.end(), p), 1);
  EXPECT_TRUE(joints({Vec3(1, 1, 1), Vec3(1, 1, 1)}).empty());
  EXPECT_TRUE(joints({Vec3(1, 1, 1)}).empty());
}

TEST(WithoutShortLegs, LeavesOutWhatTheWayNeedNotPass) {
  const geom::CollisionScene open = testing::scene_of({}, {Vec3(-90, -90, 0), Vec3(90, 90, 90)});
  const Vec3 a(0, 0, 5), b(30, 0, 5), c(30, 40, 5);
  const Vec3 near(0.01, 0, 0);
  EXPECT_EQ(without_short_legs(open, {a, b, c}, 0.1), (geom::Polyline{a, b, c}));
  EXPECT_EQ(without_short_legs(open, {a, a + near, b, c}, 0.1), (geom::Polyline{a, b, c}));
  EXPECT_EQ(without_short_legs(open, {a, b, c - near, c}, 0.1), (geom::Polyline{a, b, c}));
  EXPECT_EQ(without_short_legs(open, {a, b - near, b, c}, 0.1), (geom::Polyline{a, b, c}));
  EXPECT_EQ(without_short_legs(open, {a, a + near}, 0.1), (geom::Polyline{a, a + near}));
  EXPECT_EQ(without_short_legs(open, {a}, 0.1), (geom::Polyline{a}));
  EXPECT_TRUE(without_short_legs(open, {}, 0.1).empty());
}

// Round the end of a wall of 2 cm, whose two corners both need a bend.
TEST(WithoutShortLegs, TakesOneBendForTwoRoundACorner) {
  const geom::CollisionScene scene = testing::scene_of({{Vec3(9.99, -20, 0), Vec3(10.01, 0, 40)}},
                                                       {Vec3(-9, -90, 0), Vec3(90, 90, 90)});
  const geom::Polyline path{{0, -10, 5}, {9.98, 0.001, 5}, {10.02, 0.001, 5}, {20, -10, 5}};
  const geom::Polyline got = without_short_legs(scene, path, 0.1);
  ASSERT_EQ(got.size(), 3u);
  EXPECT_TRUE(scene.free(got[0], got[1]) && scene.free(got[1], got[2]));
  EXPECT_LT((got[1] - path[1]).norm(), 0.25);
  const geom::CollisionScene slit =  // no room outside of the turn
      testing::scene_of(
          {{Vec3(9.99, -20, 0), Vec3(10.01, 0, 40)}, {Vec3(0, 0.002, 0), Vec3(20, 9, 40)}},
          {Vec3(-9, -90, 0), Vec3(90, 90, 90)});
  EXPECT_EQ(without_short_legs(slit, path, 0.1), path);
}

TEST(WithoutShortLegs, IsFreeWhereThePathIs) {
  testing::Random random(5);
  const geom::CollisionScene scene = testing::scene_of(boxes_in_the_air(random, 200, 4, 20),
                                                       {Vec3(-90, -90, 0), Vec3(90, 90, 150)});
  int left_out = 0;
  for (int ways = 0; ways < 50;) {
    geom::Polyline path{random.vector(40) + Vec3(0, 0, 60)};
    for (int tries = 0; tries < 40; ++tries) {
      const double step = random.number(0, 1) < 0.7 ? 0.05 : 10;
      const Vec3 next = path.back() + random.vector(step);
      if (scene.free(path.back(), next)) path.push_back(next);
    }
    if (path.size() < 10) continue;
    ++ways;
    const geom::Polyline got = without_short_legs(scene, path, 0.1);
    EXPECT_EQ(got.front(), path.front());
    EXPECT_EQ(got.back(), path.back());
    for (std::size_t i = 1; i < got.size(); ++i) EXPECT_TRUE(scene.free(got[i - 1], got[i]));
    left_out += static_cast<int>(path.size() - got.size());
  }
  EXPECT_GT(left_out, 100);
}

TEST(AddPlanes, HidesEveryBoxInReachFromItsPiece) {
  testing::Random random(3);
  const std::vector<geom::Aabb> boxes = boxes_in_the_air(random, 300, 4, 20);
  const geom::CollisionScene scene =
      testing::scene_of(boxes, {Vec3(-90, -90, 0), Vec3(90, 90, 150)});
  int pieces = 0;
  while (pieces < 40) {
    const Vec3 a = random.vector(40) + Vec3(0, 0, 60);
    const Vec3 b = random.vector(40) + Vec3(0, 0, 60);
    if (!scene.free(a, b)) continue;
    ++pieces;
    Corridor corridor{{a, b, {}}};
    add_planes(scene, 10, corridor);
    for (const Plane& plane : corridor[0].planes) {
      EXPECT_LT(plane.normal.dot(a), plane.offset);
      EXPECT_LT(plane.normal.dot(b), plane.offset);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (oracle::segment_distance(a, b, scene.grown(i)) > 10) continue;
      const auto& planes = corridor[0].planes;
      EXPECT_TRUE(std::any_of(planes.begin(), planes.end(),
                              [&](const Plane& plane) { return behind(scene.grown(i), plane); }))
          << "box " << i;
    }
  }
}

TEST(AddPlanes, TakesTheBoundsInReachAsPlanes) {
  const geom::CollisionScene scene = testing::scene_of({}, {Vec3::Zero(), Vec3(100, 100, 50)});
  Corridor corridor{{Vec3(50, 50, 2), Vec3(60, 50, 3), {}}};
  add_planes(scene, 10, corridor);
  ASSERT_EQ(corridor[0].planes.size(), 1u);
  EXPECT_EQ(corridor[0].planes[0].normal, Vec3(0, 0, -1));
  EXPECT_NEAR(corridor[0].planes[0].offset, 0, 2e-3);
}

TEST(AddPlanesMet, AddsWhatTheCurveRunsIntoOnce) {
  const geom::CollisionScene scene =
      testing::scene_of({{Vec3(4, 20, 0), Vec3(6, 22, 30)}}, {Vec3(-50, -50, 0), Vec3(50, 50, 50)});
  Corridor corridor{{Vec3(0, 0, 10), Vec3(10, 0, 10), {}}};
  add_planes(scene, 10, corridor);
  const std::size_t before = corridor[0].planes.size();
  Segment wide = hermite({Vec3(0, 0, 10)}, {Vec3(10, 0, 10)}, 1);
  wide.point[3] = Vec3(5, 25, 10);
  EXPECT_EQ(add_planes_met(scene, {{wide}}, corridor), 1u);
  EXPECT_EQ(corridor[0].planes.size(), before + 1);
  EXPECT_EQ(add_planes_met(scene, {{wide}}, corridor), 0u);
}

// The box that six planes say; every obstacle must be off its interior.
geom::Aabb box_of(const CorridorPiece& piece) {
  geom::Aabb box;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(piece.planes[2 * i].normal, Vec3::Unit(i));
    EXPECT_EQ(piece.planes[2 * i + 1].normal, -Vec3::Unit(i));
    box.max[i] = piece.planes[2 * i].offset;
    box.min[i] = -piece.planes[2 * i + 1].offset;
  }
  return box;
}

// A curve that went astray over 10,000 posts, of which a map puts the nearest last: the planes that
// hide those hide nearly all.
TEST(AddPlanesMet, AddsFewPlanesForACurveFarAstray) {
  std::vector<geom::Aabb> posts;
  for (int x = -500; x < 0; x += 5) {
    for (int y = -500; y < 0; y += 5) posts.push_back({Vec3(x - 1, y - 1, 0), Vec3(x, y, 20)});
  }
  const geom::CollisionScene scene =
      testing::scene_of(posts, {Vec3(-1000, -1000, -1000), Vec3(1000, 1000, 1000)});
  Corridor corridor = pieces_between({Vec3(0, 0, 5), Vec3(-4, -4, 5)});
  Segment astray{10, {}, std::nullopt};
  astray.point.fill(Vec3(0, 0, 5));
  astray.point[3] = {-600, -500, 15};
  const std::size_t added = add_planes_met(scene, {{astray}}, corridor);
  EXPECT_GE(added, 1u);
  EXPECT_LE(added, 5u);
  const auto hidden = [&](const geom::Aabb& box) {
    return std::any_of(corridor[0].planes.begin(), corridor[0].planes.end(),
                       [&](const Plane& plane) { return geom::behind(box, plane); });
  };
  for (const std::size_t i : scene.boxes_meeting({Vec3(-60, -60, 0), Vec3(0, 0, 20)})) {
    EXPECT_TRUE(hidden(scene.grown(i))) << i;
  }
}

TEST(BoxCorridor, LeadsThroughEmptyBoxesFromStartToGoal) {
  testing::Random random(4);
  const std::vector<geom::Aabb> boxes = boxes_in_the_air(random, 150, 8, 30);
  const geom::CollisionScene scene =
      testing::scene_of(boxes, {Vec3(-90, -90, 0), Vec3(90, 90, 150)});
  int paths = 0;
  std::size_t pieces = 0;
  while (paths < 60) {
    geom::Polyline path;
    for (int i = 0; i < 4; ++i) path.push_back(random.vector(50) + Vec3(0, 0, 60));
    bool free = true;
    for (int i = 1; i < 4; ++i) free = free && scene.free(path[i - 1], path[i]);
    if (!free) continue;
    ++paths;
    const Corridor corridor = box_corridor(scene, path, 10);
    ASSERT_FALSE(corridor.empty());
    EXPECT_EQ(corridor.front().from, path.front());
    EXPECT_EQ(corridor.back().to, path.back());
    for (std::size_t i = 0; i < corridor.size(); ++i) {
      const CorridorPiece& piece = corridor[i];
      if (i) {
        EXPECT_EQ(piece.from, corridor[i - 1].to);
      }
      ASSERT_EQ(piece.planes.size(), 6u);
      const geom::Aabb box = box_of(piece);
      EXPECT_TRUE(geom::contains(box, piece.from)) << paths << ' ' << i;
      EXPECT_TRUE(geom::contains(box, piece.to)) << paths << ' ' << i;
      EXPECT_TRUE(scene.inside_bounds(box.min) && scene.inside_bounds(box.max));
      for (std::size_t b = 0; b < boxes.size(); ++b) {
        const geom::Aabb grown = scene.grown(b);
        const Vec3 shared = grown.max.cwiseMin(box.max) - grown.min.cwiseMax(box.min);
        EXPECT_LE(shared.minCoeff(), 0) << paths << ' ' << i << " box " << b;
      }
    }
    pieces += corridor.size();
  }
  EXPECT_LT(pieces, 60u * 40);
}

// Boxes come nearer and nearer to the wall, and never past it.
TEST(BoxCorridor, IsEmptyForAPathThatMeetsAnObstacle) {
  const geom::CollisionScene scene = testing::scene_of({{Vec3(20, -20, 0), Vec3(21, 20, 40)}},
                                                       {Vec3(-90, -90, 0), Vec3(90, 90, 150)});
  testing::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 from(random.number(-50, 10), random.number(-15, 15), random.number(2, 30));
    const Vec3 to(random.number(30, 60), random.number(-15, 15), random.number(2, 30));
    ASSERT_FALSE(scene.free(from, to));
    EXPECT_TRUE(box_corridor(scene, {from, to}, 10).empty());
  }
}

TEST(BoxCorridor, IsEmptyForOnePlace) {
  const geom::CollisionScene scene = testing::scene_of({}, {Vec3::Zero(), Vec3(100, 100, 50)});
  EXPECT_TRUE(box_corridor(scene, {Vec3(1, 1, 1)}, 10).empty());
  EXPECT_EQ(box_corridor(scene, {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(9, 1, 1)}, 10).size(), 3u);
}

}  // namespace
}  // namespace traj
