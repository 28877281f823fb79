#include "plan/patch/map_change.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/roadmap/patch_roadmap.h"
#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Aabb;

const Aabb kBounds{{0, 0, 0}, {60, 60, 30}};
const Vec3 kHalf(0.5, 0.5, 0.25);

Aabb random_box(support::Random& random) {
  const Vec3 low(random.stepped(-4, 58, 1), random.stepped(-4, 58, 1),
                 random.below(4) ? 0 : random.uniform(0, 28));
  const Vec3 size(random.stepped(0, 8, 1), random.uniform(0, 8), random.stepped(1, 20, 1));
  return {low, low + size};
}

// Adds, removes, moves and doubles boxes; some end at or beyond the border.
std::vector<Aabb> changed(support::Random& random, std::vector<Aabb> boxes, int changes) {
  for (int i = 0; i < changes; ++i) {
    const auto any = boxes.begin() + random.below(static_cast<int>(boxes.size()));
    switch (random.below(5)) {
      case 0:
        boxes.push_back(random_box(random));
        break;
      case 1:
        if (boxes.size() > 1) boxes.erase(any);
        break;
      case 2: {
        const Vec3 by(random.stepped(-5, 5, 1), random.uniform(-5, 5), 0);
        *any = {any->min + by, any->max + by};
        break;
      }
      case 3:
        boxes.insert(boxes.begin(), Aabb(*any));
        break;
      default: {  // onto a corner of the bounds
        const Vec3 by = (random.below(2) ? kBounds.max : kBounds.min) - any->min;
        *any = {any->min + by, any->max + by};
      }
    }
  }
  return boxes;
}

class PatchProperty : public testing::TestWithParam<std::uint64_t> {
 protected:
  support::Random random_{GetParam()};
  std::vector<Aabb> was_ = [this] {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 25; ++i) boxes.push_back(random_box(random_));
    return boxes;
  }();
};

TEST_P(PatchProperty, RoadmapEqualsTheRebuiltOne) {
  for (const bool part : {false, true}) {
    RoadmapSpec spec{4, part ? 500.0 : 25.0, {}};
    if (part) spec.region = Aabb{{10, 10, 0}, {50, 40, 30}};
    auto boxes = was_;
    auto before = scene_of(boxes, kBounds, kHalf, 0.1);
    Roadmap roadmap = build_roadmap(before, spec);
    for (int step = 0; step < 3; ++step) {  // patches of patches
      boxes = changed(random_, boxes, 1 + random_.below(5));
      auto after = scene_of(boxes, kBounds, kHalf, 0.1);
      roadmap = patch_roadmap(roadmap, after, change_since(before.map(), after),
                              {1u + static_cast<unsigned>(step), {}});
      ASSERT_EQ(bytes(roadmap), bytes(build_roadmap(after, spec)))
          << "seed " << GetParam() << ", step " << step;
      before = std::move(after);
    }
  }
}

TEST_P(PatchProperty, RoadmapMayHaveOtherBounds) {
  const auto before = scene_of(was_, kBounds, kHalf);
  const auto after = scene_of(changed(random_, was_, 3), {{-5, 1, 0}, {70, 55, 22}}, kHalf);
  const Roadmap patched =
      patch_roadmap(build_roadmap(before, {}), after, change_since(before.map(), after));
  EXPECT_EQ(bytes(patched), bytes(build_roadmap(after, {})));
}

TEST_P(PatchProperty, RoadmapMayHaveBoxesInAnotherOrder) {
  const auto before = scene_of(was_, kBounds, kHalf);
  geom::BoxMapSpec spec{.bounds = kBounds, .bounds_from = "option"};
  spec.tile_size = 7;
  const geom::CollisionScene after({spec, support::table_of(changed(random_, was_, 3))},
                                   {"box", kHalf}, 0);
  const Roadmap patched =
      patch_roadmap(build_roadmap(before, {}), after, change_since(before.map(), after));
  EXPECT_EQ(bytes(patched), bytes(build_roadmap(after, {})));
}

TEST_P(PatchProperty, RoadmapMayHaveManyChanges) {
  const auto before = scene_of(was_, kBounds, kHalf);
  const auto after = scene_of(changed(random_, was_, 150), kBounds, kHalf);
  const Roadmap patched =
      patch_roadmap(build_roadmap(before, {}), after, change_since(before.map(), after));
  EXPECT_EQ(bytes(patched), bytes(build_roadmap(after, {})));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PatchProperty, testing::Range<std::uint64_t>(1, 26));

TEST(MapChange, ListsEveryBoxAsOftenAsItChanged) {
  const Aabb a{{1, 1, 1}, {2, 2, 2}};
  const Aabb b{{3, 1, 1}, {4, 2, 2}};
  const auto before = scene_of({a, a, b}, kBounds, kHalf);
  const auto after = scene_of({a, b, b}, kBounds, kHalf);
  const MapChange change = change_since(before.map(), after);
  EXPECT_EQ(change.removed, std::vector<Aabb>{geom::grow(a, after.half())});
  EXPECT_EQ(change.added, std::vector<Aabb>{geom::grow(b, after.half())});
}

TEST(PatchRoadmap, RefusesOtherVehicles) {
  const std::vector<Aabb> boxes = {{{5, 5, 0}, {9, 9, 9}}};
  const Roadmap roadmap = build_roadmap(scene_of(boxes, kBounds, kHalf), {});
  EXPECT_THROW(patch_roadmap(roadmap, scene_of(boxes, kBounds, {1, 1, 1}), {}), geom::InputError);
}

}  // namespace
}  // namespace plan
