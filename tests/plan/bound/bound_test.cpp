#include "plan/bound/bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

#include "bound/convex_edges.h"
#include "geom/base/error.h"
#include "plan/detours.h"
#include "support/cases.h"
#include "support/fine_path.h"

namespace plan {
namespace {

using geom::Aabb;

const Aabb kRoom{{0, 0, 0}, {40, 40, 20}};

TEST(Bound, OfAFreeLineIsTheLine) {
  const auto scene = scene_of({}, kRoom);
  const LengthBound bound = Bounder(scene).ask({1, 1, 1}, {31, 41, 1}, 50, {1e-9});
  EXPECT_TRUE(bound.closed);
  EXPECT_LE(bound.bound, 50);
  EXPECT_GT(bound.bound, 50 - 1e-12);
}

// Over a wall, 30 m long and 10 m high, that reaches across the room.
TEST(Bound, OverAWallClosesOnTheTautPath) {
  const auto scene = scene_of({{{10, 0, 0}, {30, 40, 10}}}, kRoom);
  const Aabb wall = scene.grown(0);
  const double side = std::hypot(wall.min.x() - 4, wall.max.z() - 2);
  const double length = 2 * side + (wall.max.x() - wall.min.x());
  Bounder bounder(scene);
  const double end = wall.max.x() + wall.min.x() - 4;
  for (const double gap : {1e-2, 1e-3, 1e-5}) {
    const LengthBound bound = bounder.ask({4, 20, 2}, {end, 20, 2}, length, {gap});
    EXPECT_TRUE(bound.closed) << gap;
    EXPECT_LE(length / bound.bound - 1, gap);
    EXPECT_LE(bound.bound, length);
  }
}

// The wall at one end of a town of 22,500 huts, which no path past the wall comes near.
TEST(Bound, OnALargeMapLooksOnlyAtWhatShortPathsMayMeet) {
  const Aabb town{{0, 0, 0}, {2000, 1000, 20}};
  std::vector<Aabb> boxes = {{{10, 0, 0}, {30, 1000, 10}}};
  const auto alone = scene_of(boxes, town);
  for (int i = 0; i < 22500; ++i) {
    const geom::Vec3 low(200 + 10 * (i % 150), 10 + 6 * (i / 150), 0);
    boxes.push_back({low, low + geom::Vec3(4, 3, 5)});
  }
  const auto scene = scene_of(boxes, town);
  Bounder bounder(scene);
  Bounder of_the_wall(alone);
  const Vec3 from(4, 500, 2);
  const Vec3 to(36, 500, 2);
  const double shortest = 2 * std::hypot(6, 8) + 20;
  for (const double gap : {1e-2, 1e-4}) {
    const LengthBound bound = bounder.ask(from, to, shortest, {gap});
    EXPECT_TRUE(bound.closed) << gap;
    EXPECT_LE(bound.bound, shortest);
    EXPECT_GE(bound.bound, (1 - 2 * gap) * shortest);
    EXPECT_EQ(bound.bound, of_the_wall.ask(from, to, shortest, {gap}).bound) << gap;
  }
  BoundOptions proved{1e-2};
  proved.keep_proof = true;  // of the whole map
  const LengthBound bound = bounder.ask(from, to, shortest, proved);
  EXPECT_TRUE(bound.closed);
  EXPECT_TRUE(bound.proof);
}

void expect_shorter(const geom::CollisionScene& scene, const LengthBound& bound, double length) {
  if (bound.path.empty()) return;
  EXPECT_LT(geom::length(bound.path), length);
  EXPECT_LE(bound.bound, geom::length(bound.path));
  for (std::size_t i = 1; i < bound.path.size(); ++i) {
    EXPECT_TRUE(scene.free(bound.path[i - 1], bound.path[i]));
  }
}

TEST(Bound, OfALongPathFindsAShorterOne) {
  const auto scene = scene_of({{{10, 0, 0}, {30, 40, 10}}}, kRoom);
  const double shortest = 2 * std::hypot(6, 8) + 20;
  const Vec3 from(4, 20, 2);
  const Vec3 to(36, 20, 2);
  const LengthBound bound = Bounder(scene).ask(from, to, 1.2 * shortest, {1e-3});
  EXPECT_TRUE(bound.closed);
  EXPECT_LE(bound.bound, shortest + 1e-8);
  EXPECT_GT(bound.bound, 0.998 * shortest);
  ASSERT_FALSE(bound.path.empty());
  expect_shorter(scene, bound, 1.2 * shortest);
  EXPECT_EQ(bound.path.front(), from);
  EXPECT_EQ(bound.path.back(), to);
  EXPECT_LT(geom::length(bound.path), 1.001 * shortest);
}

TEST(Bound, KeepsItsProofWhereAsked) {
  const auto scene = scene_of({{{10, 0, 0}, {30, 40, 10}}}, kRoom);
  Bounder bounder(scene);
  BoundOptions options{1e-3};
  const LengthBound without = bounder.ask({4, 20, 2}, {36, 20, 2}, 40, options);
  EXPECT_FALSE(without.proof);
  options.keep_proof = true;
  const LengthBound with = bounder.ask({4, 20, 2}, {36, 20, 2}, 40, options);
  EXPECT_EQ(with.bound, without.bound);
  ASSERT_TRUE(with.proof);
  EXPECT_EQ(with.proof->levels.size(), with.levels);
  EXPECT_FALSE(with.proof->occluders.empty());
  EXPECT_TRUE(bounder.ask({4, 20, 2}, {5, 20, 2}, 1, options).proof->levels.empty());
}

TEST(Bound, WithoutStepsKnowsTheLine) {
  const auto scene = scene_of({{{10, 0, 0}, {30, 40, 10}}}, kRoom);
  const LengthBound bound = Bounder(scene).ask({4, 20, 2}, {36, 20, 2}, 40, {1e-3, 1});
  EXPECT_FALSE(bound.closed);
  EXPECT_NEAR(bound.bound, 32, 1e-12);
}

TEST(Bound, OfNoWayAtAllIsNothing) {
  const auto scene = scene_of({}, kRoom);
  const LengthBound bound = Bounder(scene).ask({4, 4, 4}, {4, 4, 4}, 0, {1e-2});
  EXPECT_TRUE(bound.closed);
  EXPECT_EQ(bound.bound, 0);
}

TEST(Bound, InFlatBoundsKnowsTheLine) {
  const auto scene =
      scene_of({{{10, 10, 0}, {30, 30, 2}}}, {{0, 0, 0}, {40, 40, 2}}, Vec3(1, 1, 1));
  const auto& bounds = *scene.free_bounds();
  ASSERT_LE(bounds.max.z() - bounds.min.z(), 1e-8);
  const double z = bounds.min.z();
  const LengthBound bound = Bounder(scene).ask({4, 20, z}, {36, 20, z}, 44, {1e-2});
  EXPECT_LE(bound.bound, 44);
}

TEST(Bound, NeedsPlaces) {
  const auto scene = scene_of({}, kRoom);
  Bounder bounder(scene);
  EXPECT_THROW(bounder.ask({1, 1, NAN}, {2, 2, 2}, 3), geom::InputError);
  EXPECT_THROW(bounder.ask({1, 1, 1}, {2, 2, 2}, 3, {0}), geom::InputError);
}

// Asked for more than there can be, it comes near the shortest path from below.
TEST(Bound, IsNeverAboveAPath) {
  int asked = 0;
  const auto seeds = static_cast<std::uint64_t>(support::cases(600));
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const auto detour = detour_for(seed);
    if (!detour) continue;
    const auto& [scene, from, to, length] = *detour;
    Bounder bounder(scene);
    const LengthBound near = bounder.ask(from, to, 1.05 * length, {1e-6, 300'000});
    ASSERT_LE(near.bound, length) << seed;
    expect_shorter(scene, near, 1.05 * length);
    EXPECT_GT(near.bound, 0.97 * length) << seed;
    ASSERT_LE(bounder.ask(from, to, length, {1e-3, 300'000}).bound, length) << seed;
    ++asked;
  }
  EXPECT_GT(asked, 80);
}

// What is to be a box so that it ends exactly at `at` once grown.
double grown_to(double at, int side) {
  double out = at - side * 5e-10;
  for (int i = 0; i < 64; ++i) {
    const Aabb box{{out, out, out}, {out, out, out}};
    const double grown =
        side > 0 ? geom::grow(box, Vec3::Zero()).max.x() : geom::grow(box, Vec3::Zero()).min.x();
    if (grown == at) return out;
    out = std::nextafter(out, grown < at ? 100 : -100);
  }
  ADD_FAILURE() << "no box ends at " << at;
  return out;
}

constexpr double kMiddle = 5;

// Some of the eight octants around the middle of a room blocked, each by a box that meets the
// others exactly there.
geom::CollisionScene octants(unsigned blocked) {
  std::vector<Aabb> boxes;
  for (unsigned octant = 0; octant < 8; ++octant) {
    if (!(blocked >> octant & 1)) continue;
    Aabb box{{2, 2, 2}, {8, 8, 8}};
    for (int k = 0; k < 3; ++k) {
      if (octant >> (2 - k) & 1) {
        box.min[k] = grown_to(kMiddle, -1);
      } else {
        box.max[k] = grown_to(kMiddle, 1);
      }
    }
    boxes.push_back(box);
  }
  return scene_of(boxes, {{0, 0, 0}, {10, 10, 10}});
}

// Places just beside the middle, in each octant and on each face between them.
std::vector<Vec3> around_the_middle() {
  std::vector<Vec3> out;
  for (int n = 0; n < 27; ++n) {
    out.push_back(Vec3::Constant(kMiddle) + 1e-6 * Vec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
  }
  return out;
}

Vec3 near_the_middle(const geom::CollisionScene& scene, support::Random& random) {
  Vec3 p;
  do {
    for (int k = 0; k < 3; ++k) p[k] = kMiddle + random.uniform(-1, 1);
  } while (!scene.free(p));
  return p;
}

// However boxes meet at a corner, by each way to block the octants around it. Where just two
// opposite ones are free, only a path that touches gets through: the bound is on these, too.
TEST(Bound, IsNeverAboveAPathByACorner) {
  int asked = 0;
  int bends = 0;
  for (unsigned blocked = 1; blocked < 255; ++blocked) {
    if (plain(blocked)) continue;
    const auto scene = octants(blocked);
    support::Random random(blocked);
    Bounder bounder(scene);
    for (int i = support::cases(6); i > 0; --i) {
      const Vec3 from = near_the_middle(scene, random);
      const Vec3 to = near_the_middle(scene, random);
      if (scene.free(from, to)) continue;
      const Vec3 middle = Vec3::Constant(kMiddle);
      double length = (from - middle).norm() + (middle - to).norm();
      const geom::Polyline path = oracle::fine_path(scene, from, to, 3, around_the_middle());
      if (!path.empty()) length = std::min(length, geom::length(path));
      const LengthBound bound = bounder.ask(from, to, 1.02 * length, {1e-4, 300'000});
      ASSERT_LE(bound.bound, length + 1e-9)
          << blocked << ": " << from.transpose() << " to " << to.transpose();
      ++asked;
      bends += path.empty() || (path[path.size() / 2] - middle).norm() < 1e-3;
    }
  }
  EXPECT_GT(asked, 300);
  EXPECT_GT(bends, 20);
}

TEST(Bound, IsTheSameFromAnyThread) {
  const auto scene = scene_for(12);
  const auto answers = [&](Bounder& bounder) {
    std::vector<double> out;
    support::Random random(3);
    for (int i = 0; i < 20; ++i) {
      const auto from = free_place(scene, random);
      const auto to = free_place(scene, random);
      out.push_back(bounder.ask(*from, *to, 1.3 * (*to - *from).norm(), {1e-3, 50'000}).bound);
    }
    return out;
  };
  Bounder alone(scene);
  const std::vector<double> expected = answers(alone);
  Bounder shared(scene);
  std::vector<double> found[3];
  std::vector<std::thread> threads;
  for (auto& some : found) threads.emplace_back([&] { some = answers(shared); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& some : found) EXPECT_EQ(some, expected);
}

}  // namespace
}  // namespace plan
