#include "geom/collision/collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "collision/groups.h"
#include "collision/queries.h"
#include "geom/base/parallel.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"
#include "support/small_map.h"

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

// Where the city stands, and how many boxes share a scene: few, so that there are many, or all.
struct Case {
  double offset;
  std::size_t boxes_per_group;
};

class CollisionProperty : public testing::TestWithParam<Case> {
 protected:
  Vec3 center() const { return {GetParam().offset, -GetParam().offset, 0}; }
  CollisionScene scene(std::uint64_t seed, double margin) const {
    return {support::random_city(seed, 120, 400, center()),
            {"box", {1, 1, 0.5}},
            margin,
            {std::size_t{1} << 29, GetParam().boxes_per_group}};
  }
};

TEST_P(CollisionProperty, HitsAgreeWithRationalsOnEveryBox) {
  const Vec3 center = this->center();
  const CollisionScene scene = this->scene(1, 0.5);
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

TEST_P(CollisionProperty, ABlockerIsAGrownBoxThatIsHitWhereThereIsOne) {
  const CollisionScene scene = this->scene(1, 0.5);
  support::Random random(14);
  std::set<std::vector<double>> grown;
  const auto key = [](const Aabb& box) {
    return std::vector<double>{box.min.x(), box.min.y(), box.min.z(),
                               box.max.x(), box.max.y(), box.max.z()};
  };
  for (std::size_t i = 0; i < scene.map().size(); ++i) grown.insert(key(scene.grown(i)));
  for (int i = 0; i < 3000; ++i) {
    const Segment s = random_segment(random, 250, center());
    const auto blocker = scene.blocker(s.a, s.b);
    ASSERT_EQ(blocker.has_value(), scene.hits(s.a, s.b)) << "case " << i;
    if (!blocker) continue;
    ASSERT_TRUE(grown.contains(key(*blocker))) << "case " << i;
    ASSERT_TRUE(oracle::segment_hits(s.a, s.b, *blocker)) << "case " << i;
  }
}

TEST_P(CollisionProperty, BlockersAreAllThatTheSegmentMeets) {
  const CollisionScene scene = this->scene(1, 0.5);
  support::Random random(15);
  std::size_t most = 0;
  for (int i = 0; i < 1000; ++i) {
    const Segment s = random_segment(random, 250, center());
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      if (oracle::segment_hits(s.a, s.b, scene.grown(k))) expected.push_back(k);
    }
    ASSERT_EQ(scene.blockers(s.a, s.b), expected) << "case " << i;
    most = std::max(most, expected.size());
  }
  EXPECT_GT(most, 2u);
}

TEST_P(CollisionProperty, NearestIsTheLowestIndexAtTheSmallestDistance) {
  const Vec3 center = this->center();
  const CollisionScene scene = this->scene(2, 0.5);
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
  const Vec3 center = this->center();
  const CollisionScene scene = this->scene(3, 0);
  support::Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const Segment s = random_segment(random, 250, center);
    const Aabb region = {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)};
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      if (overlap(region, scene.grown(k))) expected.push_back(k);
    }
    ASSERT_EQ(scene.boxes_meeting(region), expected) << "case " << i;
    const std::size_t n = expected.size();
    ASSERT_EQ(scene.boxes_meeting(region, n), expected) << "case " << i;
    ASSERT_EQ(scene.boxes_meeting(region, n + 1), expected) << "case " << i;
    if (n == 0) continue;
    ASSERT_FALSE(scene.boxes_meeting(region, n - 1)) << "case " << i;
    ASSERT_FALSE(scene.boxes_meeting(region, 0)) << "case " << i;
  }
}

TEST_P(CollisionProperty, TheNearestSoManyAreSortedAndComplete) {
  const CollisionScene scene = this->scene(5, 0.25);
  support::Random random(15);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random_segment(random, 250, center()).a;
    std::vector<std::pair<double, std::size_t>> all;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      all.push_back({distance(p, grow(scene.map().box(k), scene.vehicle().half)), k});
    }
    std::sort(all.begin(), all.end());
    const double radius = i % 2 ? all[4].first : std::numeric_limits<double>::infinity();
    const auto found = scene.nearest(p, radius, 7);
    const auto within = std::count_if(all.begin(), all.end(),
                                      [&](const auto& entry) { return entry.first <= radius; });
    ASSERT_EQ(found.size(), std::min<std::size_t>(7, within));
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].distance, all[k].first);
      ASSERT_EQ(found[k].box, all[k].second);
    }
  }
}

TEST_P(CollisionProperty, SweptBoxesAgreeWithRationals) {
  const CollisionScene scene = this->scene(6, 0);
  support::Random random(16);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Segment s = random_segment(random, 250, center());
    const Vec3 half(random.stepped(0, 4, 0.5), random.uniform(0, 4), 0.25);
    bool expected = false;
    for (const Aabb& box : scene.map().boxes()) {
      expected = expected || oracle::segment_hits(s.a, s.b, grow(box, half));
    }
    hits += expected;
    ASSERT_EQ(scene.sweep_hits(s.a, s.b, half), expected) << "case " << i;
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(hits, 550);
}

TEST_P(CollisionProperty, SeparatingPlanesKeepEveryNearBoxOffTheSegment) {
  const CollisionScene scene = this->scene(7, 0);
  support::Random random(17);
  std::size_t planes = 0;
  for (int i = 0; i < 300; ++i) {
    const Segment s = random_segment(random, 250, center());
    const auto found = scene.separating_planes(s.a, s.b, 15);
    std::vector<std::size_t> listed;
    for (const auto& [box, separation] : found) {
      listed.push_back(box);
      if (separation.gap <= 0) continue;
      ++planes;
      ASSERT_TRUE(behind(scene.grown(box), separation.plane));
      const double tolerance = 1e-12 * GetParam().offset;
      ASSERT_LE(separation.plane.normal.dot(s.a), separation.plane.offset + tolerance);
      ASSERT_LE(separation.plane.normal.dot(s.b), separation.plane.offset + tolerance);
    }
    std::sort(listed.begin(), listed.end());
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      if (distance(s.a, s.b, scene.grown(k)) <= 15) expected.push_back(k);
    }
    ASSERT_EQ(listed, expected);
  }
  EXPECT_GT(planes, 300u);
}

TEST_P(CollisionProperty, EmptyBoxesHoldTheSegmentAndNoObstacle) {
  const CollisionScene scene = this->scene(8, 0);
  support::Random random(18);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 a =
        random_segment(random, 200, center()).a.cwiseMax(0.0 * center() - Vec3(1e9, 1e9, -2));
    const Vec3 b = a + Vec3(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(0, 5));
    const auto empty = scene.empty_box(a, b, 40);
    const auto blocked = scene.boxes_meeting({a.cwiseMin(b), a.cwiseMax(b)});
    ASSERT_EQ(empty.has_value(),
              blocked.empty() && scene.inside_bounds(a) && scene.inside_bounds(b));
    if (!empty) continue;
    ++found;
    ASSERT_TRUE(contains(empty->box, a) && contains(empty->box, b));
    for (const std::size_t k : scene.boxes_meeting(empty->box)) {
      const Aabb box = scene.grown(k);
      ASSERT_TRUE((box.min.array() >= empty->box.max.array()).any() ||
                  (box.max.array() <= empty->box.min.array()).any());
    }
  }
  EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(Offsets, CollisionProperty,
                         testing::Values(Case{0, 4096}, Case{1e5, 4096}, Case{5e5, 4096},
                                         Case{0, 5}, Case{5e5, 5}));

// One frame for all groups would lose metres here.
TEST(Collision, GroupsThatLieFarApartAreAskedAsExactly) {
  std::vector<Aabb> boxes;
  for (const double x : {-9e6, 0.0, 9e6}) {
    const BoxMap city = support::random_city(8, 60, 300, {x, -x, 0});
    boxes.insert(boxes.end(), city.boxes().begin(), city.boxes().end());
  }
  const CollisionScene scene(support::map_of({{-1e7, -1e7, 0}, {1e7, 1e7, 120}}, boxes),
                             {"box", {1, 1, 0.5}}, 0.5, {std::size_t{1} << 29, 3});
  EXPECT_GT(scene.counts().groups, 12u);
  support::Random random(14);
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 centre(9e6 * (random.below(3) - 1), 0, 0);
    const Segment s = random_segment(random, 200, {centre.x(), -centre.x(), 0});
    const bool expected = brute_force(scene, s);
    hits += expected;
    ASSERT_EQ(scene.hits(s.a, s.b), expected) << "case " << i;
    const Aabb region{s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)};
    std::vector<std::size_t> meeting;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < scene.map().size(); ++k) {
      if (overlap(region, scene.grown(k))) meeting.push_back(k);
      nearest =
          std::min(nearest, distance(s.a, grow(scene.map().boxes()[k], scene.vehicle().half)));
    }
    ASSERT_EQ(scene.boxes_meeting(region), meeting) << "case " << i;
    ASSERT_EQ(scene.nearest(s.a, std::numeric_limits<double>::infinity())->distance, nearest);
  }
  EXPECT_GT(hits, 150);
}

// Once many groups were built, questions within a cell skip the upper levels of the tree over them.
TEST(Collision, ManyGroupsAreAskedAsExactly) {
  const Vec3 centre(3e5, -2e5, 0);
  CollisionScene::Impl impl(support::random_city(10, 900, 1500, centre), {"box", {1, 1, 0.5}}, 0.5,
                            {std::size_t{1} << 30, 6});
  ASSERT_GT(impl.groups.size(), 60u);
  const CollisionScene scene(impl.map, impl.vehicle, impl.margin, {std::size_t{1} << 30, 6});
  support::Random random(15);
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    Segment s = random_segment(random, 800, centre);
    if (random.below(4)) s.b = s.a + (s.b - s.a) / 10;
    const bool expected = brute_force(scene, s);
    hits += expected;
    ASSERT_EQ(hits_any(impl, s.a, s.b), expected) << "case " << i;
    const Aabb region{s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)};
    std::vector<std::size_t> meeting;
    Nearest best{0, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < impl.map.size(); ++k) {
      if (overlap(region, scene.grown(k))) meeting.push_back(k);
      const double d = distance(s.a, grow(impl.map.boxes()[k], impl.vehicle.half));
      if (d < best.distance) best = {k, d};
    }
    ASSERT_EQ(find_meeting(impl, region, impl.map.size()), meeting) << "case " << i;
    for (const double radius : {best.distance, 2 * best.distance + 1, 1e300}) {
      Nearest found;
      ASSERT_EQ(find_nearest(impl, s.a, radius, std::span(&found, 1)), 1u) << "case " << i;
      ASSERT_EQ(found.distance, best.distance) << "case " << i;
      ASSERT_EQ(found.box, best.box) << "case " << i;
    }
  }
  EXPECT_GT(hits, 80);
  EXPECT_TRUE(impl.known_cells.load());
}

// A budget that holds a scene or two: queries of several threads take them from under each other.
TEST(Collision, GivingScenesUpChangesNoAnswer) {
  const BoxMap map = support::random_city(9, 300, 600);
  std::vector<std::pair<Vec3, Vec3>> segments;
  support::Random random(19);
  for (int i = 0; i < 4000; ++i) {
    const Segment s = random_segment(random, 350, Vec3::Zero());
    segments.emplace_back(s.a, s.b);
  }
  const CollisionScene whole(map, {"box", {1, 1, 1}}, 0);
  const CollisionScene tight(map, {"box", {1, 1, 1}}, 0, {8000, 10});
  EXPECT_EQ(whole.hits(segments, {1, {}}), tight.hits(segments, {7, {}}));
}

// A group that two threads built at once would be kept, and counted, twice.
TEST(Collision, BuildsEachGroupOnceWhateverTheThreads) {
  const BoxMap map = support::random_city(4, 300, 600);
  std::vector<Segment> segments;
  support::Random random(14);
  for (int i = 0; i < 4000; ++i) segments.push_back(random_segment(random, 350, Vec3::Zero()));
  std::size_t bytes_of_one_thread = 0;
  for (const unsigned threads : {1u, 2u, 7u}) {
    CollisionScene::Impl impl(map, {"box", {1, 1, 1}}, 0, {std::size_t{1} << 30, 12});
    ASSERT_GT(impl.groups.size(), 10u);
    parallel_for(segments.size(), {threads, {}},
                 [&](std::size_t i) { hits_any(impl, segments[i].a, segments[i].b); });
    const std::set<std::size_t> built(impl.kept.begin(), impl.kept.end());
    EXPECT_EQ(built.size(), impl.kept.size());
    EXPECT_EQ(impl.counts.built, built.size());
    EXPECT_EQ(impl.counts.built_again, 0u);
    std::size_t bytes = 0;
    for (const std::size_t g : built) bytes += impl.groups[g].tree.load()->bytes;
    EXPECT_EQ(impl.bytes, bytes);
    if (threads == 1) bytes_of_one_thread = bytes;
    EXPECT_EQ(bytes, bytes_of_one_thread);
  }
}

// What is asked for again and again outlives what is asked for once.
TEST(Collision, KeepsWhatWasTouchedSinceTheHandPassed) {
  const BoxMap map = support::random_city(4, 600, 1200);
  CollisionScene::Impl impl(map, {"box", {1, 1, 1}}, 0, {std::size_t{1} << 14, 12});
  ASSERT_GT(impl.groups.size(), 30u);
  const Vec3 often = map.box(0).min;
  for (std::size_t i = 0; i < map.size(); ++i) {
    hits_any(impl, often, often);
    hits_any(impl, map.box(i).min, map.box(i).min);
  }
  const std::size_t other = impl.counts.built + impl.counts.built_again;
  EXPECT_GT(impl.counts.built_again, 0u);  // the budget holds a part of the map
  EXPECT_LE(impl.bytes, impl.budget);
  hits_any(impl, often, often);
  EXPECT_EQ(impl.counts.built + impl.counts.built_again, other);
}

TEST(Collision, AnEmptyMapIsFreeInsideItsBounds) {
  const CollisionScene scene(support::map_of({{0, 0, 0}, {10, 10, 10}}, {}), {"box", {1, 1, 1}}, 0);
  EXPECT_TRUE(scene.free({1, 1, 1}, {9, 9, 9}));
  EXPECT_FALSE(scene.free({0.5, 1, 1}, {9, 9, 9}));
  EXPECT_FALSE(scene.nearest({5, 5, 5}, 100));
}

TEST(Collision, TouchingTheBoundsIsAllowedAndTouchingAnObstacleIsNot) {
  const BoxMap map = support::map_of({{0, 0, 0}, {10, 10, 10}}, {{{4, 4, 0}, {5, 5, 5}}});
  const CollisionScene scene(map, {"box", {1, 1, 1}}, 0);
  EXPECT_TRUE(scene.free({1, 1, 1}));
  EXPECT_FALSE(scene.free({3, 4.5, 3}));  // 1 m from the face
  EXPECT_TRUE(scene.free({2.999999, 4.5, 3}));
}

}  // namespace
}  // namespace geom
