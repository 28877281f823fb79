#include "geom/collision.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/parallel.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

struct Segment {
  Vec3 a;
  Vec3 b;
};

Segment random_segment(support::Random& random, double side, const Vec3& center) {
  const auto point = [&] {
    const auto coordinate = [&](double low, double high) {
      return random.below(2) ? random.stepped(low, high, 0.5) : random.uniform(low, high);
    };
    return Vec3(center +
                Vec3(coordinate(-side, side), coordinate(-side, side), coordinate(-5, 70)));
  };
  const Vec3 a = point();
  switch (random.below(4)) {
    case 0:
      return {a, a};
    case 1:
      return {a, a + Vec3(random.stepped(-60, 60, 1), 0, 0)};
    case 2:
      return {a, a + Vec3(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-9, 9))};
    default:
      return {a, point()};
  }
}

bool brute_force(const CollisionScene& scene, const Segment& s) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    if (oracle::segment_hits(s.a, s.b, scene.grown(i))) return true;
  }
  return false;
}

class CollisionProperty : public testing::TestWithParam<double> {};

TEST_P(CollisionProperty, HitsAgreeWithRationalsOnEveryBox) {
  const Vec3 center(GetParam(), -GetParam(), 0);
  const CollisionScene scene(support::random_city(1, 120, 400, center), {"box", {1, 1, 0.5}}, 0.5);
  support::Random random(11);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Segment s = random_segment(random, 250, center);
    const bool expected = brute_force(scene, s);
    hits += expected;
    ASSERT_EQ(scene.hits(s.a, s.b), expected)
        << "case " << i << ": " << s.a.transpose() << " to " << s.b.transpose();
  }
  EXPECT_GT(hits, 300);
  EXPECT_LT(hits, 2700);
}

TEST_P(CollisionProperty, NearestIsTheLowestIndexAtTheSmallestDistance) {
  const Vec3 center(GetParam(), -GetParam(), 0);
  const CollisionScene scene(support::random_city(2, 120, 400, center), {"box", {1, 1, 0.5}}, 0.5);
  support::Random random(12);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random_segment(random, i % 10 ? 250 : 4000, center).a;
    Nearest best{0, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      const double d = distance(p, grow(scene.map().boxes()[k], scene.vehicle().half));
      if (d < best.distance) best = {k, d};
    }
    const auto found = scene.nearest(p, std::numeric_limits<double>::infinity());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->distance, best.distance) << "case " << i;
    ASSERT_EQ(found->box, best.box) << "case " << i;
    const double closer = std::nextafter(best.distance, 0);
    if (best.distance > 0) {
      ASSERT_TRUE(scene.nearest(p, best.distance));
      ASSERT_FALSE(scene.nearest(p, closer));
    }
  }
}

TEST_P(CollisionProperty, BoxesMeetingARegionAreAllAndOnlyThose) {
  const Vec3 center(GetParam(), -GetParam(), 0);
  const CollisionScene scene(support::random_city(3, 120, 400, center), {"box", {1, 1, 0.5}}, 0);
  support::Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const Segment s = random_segment(random, 250, center);
    const Aabb region = {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)};
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      if (overlap(region, scene.grown(k))) expected.push_back(k);
    }
    ASSERT_EQ(scene.boxes_meeting(region), expected) << "case " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, CollisionProperty, testing::Values(0.0, 1e5, 5e5));

TEST(Collision, TilesAreBuiltOnceWhateverTheThreads) {
  const BoxMap map = support::random_city(4, 300, 600);
  std::vector<Segment> segments;
  support::Random random(14);
  for (int i = 0; i < 4000; ++i) segments.push_back(random_segment(random, 350, Vec3::Zero()));
  std::vector<std::vector<char>> answers;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const CollisionScene scene(map, {"box", {1, 1, 1}}, 0);
    std::vector<char> hit(segments.size());
    parallel_for(segments.size(), {threads, {}},
                 [&](std::size_t i) { hit[i] = scene.hits(segments[i].a, segments[i].b); });
    answers.push_back(hit);
  }
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

TEST(Collision, AnEmptyMapIsFreeInsideItsBounds) {
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {10, 10, 10}};
  const CollisionScene scene(BoxMap(spec, support::table_of({})), {"box", {1, 1, 1}}, 0);
  EXPECT_TRUE(scene.free({1, 1, 1}, {9, 9, 9}));
  EXPECT_FALSE(scene.free({0.5, 1, 1}, {9, 9, 9}));
  EXPECT_FALSE(scene.nearest({5, 5, 5}, 100));
}

TEST(Collision, TouchingTheBoundsIsAllowedAndTouchingAnObstacleIsNot) {
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {10, 10, 10}};
  const BoxMap map(spec, support::table_of({{{4, 4, 0}, {5, 5, 5}}}));
  const CollisionScene scene(map, {"box", {1, 1, 1}}, 0);
  EXPECT_TRUE(scene.free({1, 1, 1}));
  EXPECT_FALSE(scene.free({3, 4.5, 3}));  // 1 m from the face
  EXPECT_TRUE(scene.free({2.999999, 4.5, 3}));
}

}  // namespace
}  // namespace geom
