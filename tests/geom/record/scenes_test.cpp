#include "geom/record/scenes.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "geom/base/parallel.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

constexpr std::size_t kBudget = std::size_t{1} << 29;

Provenance made_for(double half, double margin = 0) {
  Provenance record;
  record.vehicle = Vehicle{"box", Vec3::Constant(half)};
  record.margin = margin;
  return record;
}

Scenes scenes_of(int boxes = 60) {
  return {support::random_city(7, boxes, 100), {}, Differences::refused, kBudget};
}

// As a scene of its own answers: the least distance is that of the boxes grown by this vehicle.
void expect_of(const CollisionScene& scene, const Provenance& record) {
  EXPECT_EQ(scene.vehicle(), *record.vehicle);
  EXPECT_EQ(scene.margin(), record.margin.value_or(0));
  const CollisionScene own(scene.map(), *record.vehicle, record.margin.value_or(0));
  for (const Vec3& p : {Vec3(0, 0, 5), Vec3(40, -30, 20), Vec3(-60, 10, 2)}) {
    EXPECT_EQ(scene.nearest(p, 1000)->distance, own.nearest(p, 1000)->distance);
    EXPECT_EQ(scene.free(p), own.free(p));
  }
}

TEST(Scenes, AreOneForEachVehicleAndMargin) {
  Scenes scenes = scenes_of();
  std::set<const CollisionScene*> known;
  std::vector<std::shared_ptr<const CollisionScene>> held;
  for (int round = 0; round < 3; ++round) {
    for (const Provenance& record : {made_for(1), made_for(2), made_for(1, 0.5)}) {
      held.push_back(scenes.shared_scene_for(record, "f", 1));
      expect_of(*held.back(), record);
      known.insert(held.back().get());
    }
  }
  EXPECT_EQ(known.size(), 3u);
  EXPECT_EQ(scenes.counts().built, 3u);
}

// A fleet of very many vehicles: those before the last few are gone once nobody holds them.
TEST(Scenes, AreKeptInABoundedNumber) {
  Scenes scenes = scenes_of();
  std::vector<std::weak_ptr<const CollisionScene>> seen;
  for (int i = 0; i < 1000; ++i) {
    const auto scene = scenes.shared_scene_for(made_for(0.5 + 1e-3 * i), "f", 1);
    scene->nearest({0, 0, 5}, 100);
    seen.push_back(scene);
  }
  std::size_t alive = 0;
  for (const auto& scene : seen) alive += !scene.expired();
  EXPECT_EQ(alive, Scenes::kMostScenes);
  EXPECT_FALSE(seen[1000 - Scenes::kMostScenes].expired());
  EXPECT_EQ(scenes.counts().built, 1000u);
  const auto again = scenes.shared_scene_for(made_for(0.5), "f", 1);  // dropped long ago
  expect_of(*again, made_for(0.5));
}

TEST(Scenes, KeepThoseThatAreAskedForAgain) {
  Scenes scenes = scenes_of();
  const std::weak_ptr<const CollisionScene> first = scenes.shared_scene_for(made_for(9), "f", 1);
  for (int i = 0; i < 300; ++i) {
    scenes.shared_scene_for(made_for(0.5 + 1e-3 * i), "f", 1);
    scenes.shared_scene_for(made_for(9), "f", 1);
    ASSERT_FALSE(first.expired()) << i;
  }
}

// The trees of a large map would take more than a share of the budget: fewer scenes are kept, and
// together these take no more than it.
TEST(Scenes, ShareTheBudget) {
  constexpr std::size_t kSmall = std::size_t{1} << 19;
  Scenes scenes(support::random_city(7, 20000, 6000), {}, Differences::refused, kSmall);
  std::vector<std::weak_ptr<const CollisionScene>> seen;
  for (int i = 0; i < 40; ++i) {
    const auto scene = scenes.shared_scene_for(made_for(0.5 + 1e-3 * i), "f", 1);
    for (double x = -2900; x < 3000; x += 250) {
      for (double y = -2900; y < 3000; y += 250) scene->nearest({x, y, 5}, 50);
    }
    seen.push_back(scene);
    std::size_t alive = 0;
    std::size_t bytes = 0;
    for (const auto& one : seen) {
      if (const auto kept = one.lock()) {
        ++alive;
        bytes += kept->counts().most_bytes;
      }
    }
    ASSERT_LE(alive, Scenes::kScenesOfLargeMap) << i;
    // A group that is being built comes on top.
    ASSERT_LE(bytes, kSmall + alive * (std::size_t{1} << 16)) << i;
  }
  EXPECT_GT(scenes.counts().built_again, 0u);
}

TEST(Scenes, ServeThreadsAtOnce) {
  Scenes scenes = scenes_of(400);
  std::vector<double> found(400);
  parallel_for(found.size(), {.threads = 8}, [&](std::size_t i) {
    const auto record = made_for(0.5 + 0.01 * static_cast<double>(i % 100));
    found[i] = scenes.shared_scene_for(record, "f", i)->nearest({0, 0, 5}, 1000)->distance;
  });
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], found[i % 100]);
}

TEST(Scenes, RefuseARecordOfAnotherMap) {
  Scenes scenes = scenes_of();
  Provenance record = made_for(1);
  record.map = "sha256:0";
  EXPECT_NE(support::refusal_of([&] { scenes.shared_scene_for(record, "f", 3); }), "");
}

TEST(Scenes, SayWhetherARecordIsOfTheLastOne) {
  Scenes scenes = scenes_of();
  scenes.scene_for(made_for(1), "f", 1);
  scenes.require_same_room(made_for(1), "f", 2);
  EXPECT_NE(support::refusal_of([&] { scenes.require_same_room(made_for(2), "f", 2); }), "");
}

}  // namespace
}  // namespace geom
