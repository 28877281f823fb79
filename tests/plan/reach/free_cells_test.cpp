// What a question leaves behind that ran out of memory: nothing that a later one believes.

#include <gtest/gtest.h>

#include <new>

#include "plan/bound/bound.h"
#include "plan/reach/reach.h"
#include "plan/scenes.h"
#include "support/failing_memory.h"

namespace plan {
namespace {

using support::FailingMemory;

constexpr double kSide = 12;

class FailedQuestion : public testing::TestWithParam<FailingMemory::Then> {};

// Boxes anywhere, and a closed shell around the middle.
geom::CollisionScene shell_among_boxes(std::uint64_t seed) {
  support::Random random(seed);
  std::vector<geom::Aabb> boxes = random_boxes(random, 12, kSide);
  for (int k = 0; k < 3; ++k) {
    for (const double at : {3.0, 8.5}) {
      geom::Aabb wall{Vec3::Constant(3), Vec3::Constant(9)};
      wall.min[k] = at;
      wall.max[k] = at + 0.5;
      boxes.push_back(wall);
    }
  }
  return scene_of(boxes, {Vec3::Zero(), Vec3::Constant(kSide)}, Vec3::Constant(0.2));
}

Vec3 free_place(const geom::CollisionScene& scene, double low, double high) {
  support::Random random(5);
  while (true) {
    const Vec3 p(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
    if (scene.free(p)) return p;
  }
}

// Lets each allocation of a first question fail in turn, and asks again. Returns how many failed.
template <class Asker, class Ask, class Same>
int fail_each_allocation(const geom::CollisionScene& scene, FailingMemory::Then then,
                         const Ask& ask, const Same& expect_same) {
  for (int n = 0;; ++n) {
    Asker asker(scene);
    try {
      const FailingMemory short_of_memory(n, then);
      ask(asker);
    } catch (const std::bad_alloc&) {
    }
    const bool failed = FailingMemory::any_failed();
    expect_same(ask(asker));
    if (!failed || testing::Test::HasFailure()) return n;
  }
}

TEST_P(FailedQuestion, LeavesNoCellThatALaterOneTakesForFree) {
  int failures = 0;
  int apart = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto scene = shell_among_boxes(seed);
    const Vec3 inside = free_place(scene, 4, 8);
    const Vec3 near = free_place(scene, 0.2, 2.5);
    const Vec3 far = free_place(scene, 9.5, 11.8);
    for (const Vec3& to : {inside, far}) {
      const ReachResult right = Reach(scene).ask(near, to);
      apart += right.answer == Reachable::no;
      failures += fail_each_allocation<Reach>(
          scene, GetParam(), [&](Reach& reach) { return reach.ask(near, to); },
          [&](const ReachResult& again) {
            EXPECT_EQ(again.answer, right.answer);
            EXPECT_EQ(again.cells, right.cells);
            EXPECT_EQ(again.looked_at, right.looked_at);
          });
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(failures, 500);
  EXPECT_EQ(apart, 3);
}

TEST_P(FailedQuestion, LeavesNoBoundThatIsAnother) {
  const std::vector<geom::Aabb> walls = {{Vec3(0, 5, 0), Vec3(9, 6, 10)},
                                         {Vec3(4, 8, 0), Vec3(12, 9, 9)}};
  const auto scene = scene_of(walls, {Vec3::Zero(), Vec3::Constant(kSide)}, Vec3::Constant(0.2));
  const Vec3 from(2, 2, 2);
  const Vec3 to(9, 11, 3);
  const double length = 1.4 * (to - from).norm();
  const auto ask = [&](Bounder& bounder) { return bounder.ask(from, to, length); };
  Bounder whole(scene);
  const LengthBound right = ask(whole);
  const int failures =
      fail_each_allocation<Bounder>(scene, GetParam(), ask, [&](const LengthBound& again) {
        EXPECT_EQ(again.bound, right.bound);
        EXPECT_EQ(again.closed, right.closed);
        EXPECT_EQ(again.steps, right.steps);
      });
  EXPECT_GT(failures, 100);
}

INSTANTIATE_TEST_SUITE_P(MemoryThen, FailedQuestion,
                         testing::Values(FailingMemory::Then::works, FailingMemory::Then::fails),
                         [](const auto& then) {
                           return then.param == FailingMemory::Then::works ? "Works" : "Fails";
                         });

}  // namespace
}  // namespace plan
