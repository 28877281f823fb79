#include "plan/sampling/rrt.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "geom/base/error.h"
#include "geom/base/sha256.h"
#include "plan/scenes.h"
#include "support/exact_oracle.h"

namespace plan {
namespace {

using geom::CollisionScene;
using oracle::Q;

constexpr SamplingMethod kMethods[] = {SamplingMethod::rrt, SamplingMethod::rrt_connect,
                                       SamplingMethod::rrt_star, SamplingMethod::informed_rrt_star};
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();
const geom::Aabb kRoom{{0, 0, 0}, {100, 100, 100}};

// A pillar from floor to ceiling that stands in the way; the shorter way is around its lower side.
CollisionScene pillar() { return scene_of({{{45, 20, -1}, {55, 80, 101}}}, kRoom); }
const SamplingOptions kCityWide{.step = 15, .radius = 30};
const Vec3 kFrom(20, 45, 50);
const Vec3 kTo(80, 45, 50);
const double kAround = 2 * std::hypot(25, 25) + 10;

// The goal in a closed shell of six boxes.
CollisionScene walled_in(const Vec3& goal) {
  std::vector<geom::Aabb> boxes;
  for (int k = 0; k < 3; ++k) {
    for (const double side : {-5.0, 5.0}) {
      const Vec3 middle = goal + side * Vec3::Unit(k);
      const Vec3 half = Vec3::Constant(6) - 5 * Vec3::Unit(k);
      boxes.push_back({middle - half, middle + half});
    }
  }
  return scene_of(boxes, kRoom);
}

// In rationals; boxes that are clear of the segment's own are passed over.
bool exactly_free(const CollisionScene& scene, const Vec3& a, const Vec3& b) {
  const Vec3& half = scene.vehicle().half;
  const geom::Aabb& bounds = scene.map().spec().bounds;
  for (const Vec3& p : {a, b}) {
    for (int k = 0; k < 3; ++k) {
      if (Q(p[k]) - Q(half[k]) < Q(bounds.min[k])) return false;
      if (Q(p[k]) + Q(half[k]) > Q(bounds.max[k])) return false;
    }
  }
  const geom::Aabb around{a.cwiseMin(b), a.cwiseMax(b)};
  for (const geom::Aabb& box : scene.map().boxes()) {
    if (geom::overlap(around, geom::grow(box, half)) && oracle::segment_hits(a, b, box, half)) {
      return false;
    }
  }
  return true;
}

// The length of the way from the root, added up anew from there; fails where there is none.
double resummed(const SearchTree& tree, std::uint32_t node) {
  std::vector<std::uint32_t> way;
  for (; tree.parent[node] != node; node = tree.parent[node]) {
    way.push_back(node);
    if (way.size() > tree.points.size()) return kNan;
  }
  double sum = 0;
  for (; !way.empty(); way.pop_back()) {
    sum += (tree.points[way.back()] - tree.points[node]).norm();
    node = way.back();
  }
  return sum;
}

void expect_sound(const CollisionScene& scene, const SamplingResult& result, const Vec3& from,
                  const Vec3& to) {
  const SearchTree& tree = result.tree;
  ASSERT_FALSE(tree.points.empty());
  EXPECT_EQ(tree.points[0], from);
  for (std::uint32_t i = 0; i < tree.points.size(); ++i) {
    for (const std::uint32_t parent : {tree.parent[i], tree.first_parent[i]}) {
      ASSERT_TRUE(exactly_free(scene, tree.points[parent], tree.points[i])) << parent << "-" << i;
      ASSERT_EQ(tree.tree[parent], tree.tree[i]);
    }
    ASSERT_LE(tree.first_parent[i], i);
    ASSERT_EQ(tree.first_parent[i] == i, tree.parent[i] == i);
    ASSERT_EQ(tree.cost[i], resummed(tree, i)) << i;
  }
  EXPECT_EQ(result.found, !result.path.empty());
  if (!result.found) return;
  EXPECT_EQ(result.path.front(), from);
  EXPECT_EQ(result.path.back(), to);
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    EXPECT_TRUE(exactly_free(scene, result.path[i - 1], result.path[i]));
  }
}

TEST(SamplePath, GrowsOnlyWhatIsFreeInRationals) {
  int found = 0;
  for (const SamplingMethod method : kMethods) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(std::string(name(method)) + " " + std::to_string(seed));
      const Vec3 half = Vec3::Constant(seed % 2 ? 0.25 : 0);
      const auto scene = random_scene(seed, 150, 20, half);
      support::Random random(seed);
      Vec3 ends[2];
      for (Vec3& p : ends) {
        do {
          p = {random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 20)};
        } while (!scene.free(p));
      }
      const SamplingOptions options{
          .step = 2.5, .iterations = 800, .radius = 6, .seed = seed, .straight_first = false};
      const auto result = sample_path(scene, ends[0], ends[1], method, options);
      expect_sound(scene, result, ends[0], ends[1]);
      found += result.found;
    }
  }
  EXPECT_GT(found, 12);
}

TEST(SamplePath, KeepsTheStepOfTreesThatGrowBySteps) {
  const auto scene = pillar();
  for (const SamplingMethod method : {SamplingMethod::rrt, SamplingMethod::rrt_connect}) {
    const auto result = sample_path(scene, kFrom, kTo, method, {.step = 7});
    ASSERT_TRUE(result.found);
    for (std::size_t i = 1; i < result.path.size(); ++i) {
      EXPECT_LE((result.path[i] - result.path[i - 1]).norm(), 7 * (1 + 1e-12));
    }
    EXPECT_EQ(result.iterations, result.first_found);
    EXPECT_NEAR(result.first_length, geom::length(result.path), 1e-9);
  }
}

TEST(SamplePath, OfConnectGrowsOneTreeFromEachEnd) {
  const auto result = sample_path(pillar(), kFrom, kTo, SamplingMethod::rrt_connect);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.tree.points[0], kFrom);
  EXPECT_EQ(result.tree.points[1], kTo);
  EXPECT_EQ(result.tree.parent[1], 1u);
  EXPECT_EQ(result.tree.tree[1], 1);
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    EXPECT_NE(result.path[i - 1], result.path[i]);  // the meeting point comes once
  }
}

TEST(SamplePath, OfStarsComesCloseToTheShortestWayRoundABox) {
  const auto scene = pillar();
  const auto star = sample_path(scene, kFrom, kTo, SamplingMethod::rrt_star, kCityWide);
  const auto informed =
      sample_path(scene, kFrom, kTo, SamplingMethod::informed_rrt_star, kCityWide);
  for (const auto* result : {&star, &informed}) {
    ASSERT_TRUE(result->found);
    EXPECT_EQ(result->iterations, 20000u);
    EXPECT_GT(geom::length(result->path), kAround);
    EXPECT_LT(result->first_found, 2000u);
    EXPECT_GE(result->first_length, geom::length(result->path));
    for (std::uint32_t i = 0; i < result->tree.points.size(); ++i) {
      ASSERT_EQ(result->tree.cost[i], resummed(result->tree, i)) << i;
    }
  }
  EXPECT_LT(geom::length(star.path), 1.05 * kAround);
  EXPECT_LT(geom::length(informed.path), 1.03 * kAround);
}

// Where a step reaches everything, nodes are samples.
TEST(SamplePath, OfInformedSamplesOnlyTheSpheroidOnceItHasAPath) {
  const auto scene = pillar();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SamplingOptions options{.step = kInfinity, .iterations = 2000, .seed = seed};
    const auto result = sample_path(scene, kFrom, kTo, SamplingMethod::informed_rrt_star, options);
    ASSERT_TRUE(result.found);
    EXPECT_LE(geom::length(result.path), result.first_length);
    options.iterations = result.first_found;
    const auto before = sample_path(scene, kFrom, kTo, SamplingMethod::informed_rrt_star, options);
    ASSERT_LT(before.tree.points.size() + 100, result.tree.points.size());
    for (std::size_t i = before.tree.points.size(); i < result.tree.points.size(); ++i) {
      const Vec3& p = result.tree.points[i];
      EXPECT_LE((p - kFrom).norm() + (kTo - p).norm(), result.first_length * (1 + 1e-12));
    }
  }
}

// The sums change with the methods, and must not with the machine or the compiler.
TEST(SamplePath, IsTheSameForASeedOnEveryMachineAndAnotherForAnother) {
  const std::array<std::string, 4> sums = {"116c3c64e8d92c84", "80a9e8cd533bf9a9",
                                           "ae316435a36a07f4", "24807fc9a8962119"};
  const auto scene = pillar();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    SamplingOptions options{.step = 15, .iterations = 3000, .radius = 30, .seed = 1};
    const SearchTree tree = sample_path(scene, kFrom, kTo, kMethods[i], options).tree;
    geom::Sha256 sum;
    for (const Vec3& p : tree.points) sum.update(std::as_bytes(std::span(p.data(), 3)));
    sum.update(std::as_bytes(std::span(tree.parent)));
    sum.update(std::as_bytes(std::span(tree.cost)));
    EXPECT_EQ(sum.hex().substr(0, 16), sums[i]) << name(kMethods[i]);
    options.seed = 2;
    EXPECT_NE(sample_path(scene, kFrom, kTo, kMethods[i], options).tree, tree);
  }
}

TEST(SamplePath, EndsAfterTheIterationsWhereTheGoalIsWalledIn) {
  const auto scene = walled_in(kTo);
  for (const SamplingMethod method : kMethods) {
    const auto result = sample_path(scene, kFrom, kTo, method, {.iterations = 2000});
    EXPECT_FALSE(result.found);
    EXPECT_TRUE(result.path.empty());
    EXPECT_EQ(result.iterations, 2000u);
    EXPECT_GT(result.tree.points.size(), 100u);
    EXPECT_LE(result.tree.points.size(), 2002u);
  }
}

TEST(SamplePath, IsTheStraightLineWhereThatIsFreeUnlessToldOtherwise) {
  const auto scene = pillar();
  const Vec3 near(20, 90, 50);
  for (const SamplingMethod method : kMethods) {
    const auto straight = sample_path(scene, kFrom, near, method);
    EXPECT_TRUE(straight.found);
    EXPECT_EQ(straight.path, (geom::Polyline{kFrom, near}));
    EXPECT_EQ(straight.iterations, 0u);
    expect_sound(scene, straight, kFrom, near);
    const auto grown =
        sample_path(scene, kFrom, near, method, {.iterations = 500, .straight_first = false});
    EXPECT_TRUE(grown.found);
    EXPECT_GT(grown.iterations, 0u);
    expect_sound(scene, grown, kFrom, near);
  }
}

TEST(SamplePath, OfEqualEndsNeedsNoSearch) {
  const auto scene = pillar();
  for (const SamplingMethod method : kMethods) {
    const auto result = sample_path(scene, kFrom, kFrom, method, {.straight_first = false});
    EXPECT_TRUE(result.found);
    EXPECT_EQ(result.path, (geom::Polyline{kFrom, kFrom}));
    EXPECT_EQ(result.iterations, 0u);
    expect_sound(scene, result, kFrom, kFrom);
  }
}

TEST(SamplePath, FindsNothingWhereAnEndIsNotFree) {
  const auto scene = pillar();
  for (const SamplingMethod method : kMethods) {
    for (const Vec3& bad : {Vec3(50, 50, 50), Vec3(-1, 50, 50), Vec3(kNan, 50, 50)}) {
      for (const auto& result :
           {sample_path(scene, bad, kTo, method), sample_path(scene, kFrom, bad, method)}) {
        EXPECT_FALSE(result.found);
        EXPECT_TRUE(result.tree.points.empty());
        EXPECT_EQ(result.iterations, 0u);
      }
    }
  }
}

TEST(SamplePath, RefusesOptionsOutOfRange) {
  const auto scene = pillar();
  const auto refused = [&](const SamplingOptions& options) {
    EXPECT_THROW(sample_path(scene, kFrom, kTo, SamplingMethod::rrt, options), geom::InputError);
  };
  for (const double bad : {kNan, 0.0, -1.0}) refused({.step = bad});
  for (const double bad : {kNan, -0.1, 1.1}) refused({.goal_bias = bad});
  for (const double bad : {kNan, -1.0}) refused({.radius = bad});
  refused({.iterations = std::size_t{1} << 31});
}

TEST(SamplePath, TakesExtremeOptions) {
  const auto scene = pillar();
  for (const SamplingMethod method : kMethods) {
    const SamplingOptions kExtremes[] = {
        {.step = 1e-300, .iterations = 50},
        {.step = 1e-9, .iterations = 50},
        {.goal_bias = 1, .iterations = 50},
        {.goal_bias = 0, .iterations = 50},
        {.iterations = 0},
        {.iterations = 50, .radius = 0},
        {.step = kInfinity, .iterations = 50, .radius = kInfinity}};
    for (const SamplingOptions& options : kExtremes) {
      const auto result = sample_path(scene, kFrom, kTo, method, options);
      EXPECT_LE(result.iterations, options.iterations);
      expect_sound(scene, result, kFrom, kTo);
    }
  }
}

// What is left open fits the bounds: 100 m here, a third of what counts as a city.
TEST(SamplePath, TakesDefaultsThatFitTheMap) {
  const auto scene = pillar();
  for (const SamplingMethod method : kMethods) {
    const SamplingOptions fitting{.step = 5, .iterations = 3000, .radius = 10};
    const auto asked = sample_path(scene, kFrom, kTo, method, fitting);
    EXPECT_EQ(sample_path(scene, kFrom, kTo, method, {.iterations = 3000}).tree, asked.tree);
  }
}

TEST(SamplePath, GoesOnForLongerWhereTheMapIsSmallAndTheFirstPathEndsIt) {
  const auto scene = walled_in(kTo);
  EXPECT_EQ(sample_path(scene, kFrom, kTo, SamplingMethod::rrt).iterations, 100000u);
  EXPECT_EQ(sample_path(scene, kFrom, kTo, SamplingMethod::rrt_star).iterations, 20000u);
}

TEST(SamplePath, StopsWhenAsked) {
  const auto scene = walled_in(kTo);
  for (const SamplingMethod method : kMethods) {
    int asked = 0;
    SamplingOptions options;
    options.stop = [&] { return ++asked > 10; };
    const auto result = sample_path(scene, kFrom, kTo, method, options);
    EXPECT_TRUE(result.stopped);
    EXPECT_LE(result.iterations, 10u * 16);
    expect_sound(scene, result, kFrom, kTo);
  }
}

TEST(SamplePath, OfStarsEndsOncePatienceDoes) {
  const auto scene = pillar();
  for (const SamplingMethod method :
       {SamplingMethod::rrt_star, SamplingMethod::informed_rrt_star}) {
    const auto result =
        sample_path(scene, kFrom, kTo, method, {.step = 15, .radius = 30, .patience = 1000});
    EXPECT_TRUE(result.found);
    EXPECT_FALSE(result.stopped);
    EXPECT_GE(result.iterations, result.first_found + 1000);
    EXPECT_LT(result.iterations, 20000u);
    EXPECT_LT(geom::length(result.path), 1.15 * kAround);
  }
}

TEST(SamplePath, WorksWhereTheBoundsAreFlat) {
  const auto scene = scene_of({{{45, 20, -1}, {55, 80, 101}}}, {{0, 0, 50}, {100, 100, 50}});
  for (const SamplingMethod method : kMethods) {
    const auto result =
        sample_path(scene, kFrom, kTo, method, {.step = 15, .iterations = 2000, .radius = 30});
    EXPECT_TRUE(result.found);
    expect_sound(scene, result, kFrom, kTo);
  }
}

}  // namespace
}  // namespace plan
