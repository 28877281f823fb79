#include "plan/roadmap/roadmap_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "plan/file_bytes.h"
#include "plan/planner/plan.h"
#include "plan/roadmap/roadmap_file.h"
#include "support/random_city.h"

namespace plan {
namespace {

constexpr RoadmapSpec kSpec{10, 70, {}};

geom::CollisionScene city(std::uint64_t seed) {
  return {support::random_city(seed, 60, 200), {"box", {1, 1, 0.5}}, 0.25};
}

struct Ends {
  Vec3 from;
  Vec3 to;
};

std::vector<Ends> blocked_ends(const geom::CollisionScene& scene, std::uint64_t seed, int count) {
  support::Random random(seed);
  std::vector<Ends> out;
  while (out.size() < static_cast<std::size_t>(count)) {
    const auto point = [&] {
      return Vec3(random.uniform(-190, 190), random.uniform(-190, 190), random.uniform(1, 20));
    };
    const Ends ends{point(), point()};
    if (!scene.free(ends.from) || !scene.free(ends.to) || scene.free(ends.from, ends.to)) continue;
    out.push_back(ends);
  }
  return out;
}

Roadmap through_file(const Roadmap& roadmap) {
  const std::string written = bytes(roadmap);
  return read_roadmap(geom::ArrayArchive::from_bytes(std::as_bytes(std::span(written)), "test"),
                      Filled::allowed);
}

void expect_same(RoadmapSearch& whole, RoadmapSearch& filled, const Ends& ends) {
  const RoadmapResult a = whole.search(ends.from, ends.to, {20000, 3, 0.1});
  const RoadmapResult b = filled.search(ends.from, ends.to, {20000, 3, 0.1});
  ASSERT_EQ(a.settled, b.settled);
  ASSERT_EQ(a.paths, b.paths);
}

class RoadmapFillProperty : public testing::TestWithParam<std::uint64_t> {};

// Empty, from a file with half of the queries, and from one with all of them.
TEST_P(RoadmapFillProperty, SearchesFindWhatTheyFindInTheWholeRoadmap) {
  const auto scene = city(GetParam());
  const Roadmap roadmap = build_roadmap(scene, kSpec, {2, {}});
  RoadmapSearch whole(scene, roadmap);
  const auto ends = blocked_ends(scene, GetParam(), 30);
  std::optional<Roadmap> known;
  for (const std::size_t some : {15u, 30u}) {
    RoadmapFill fill(scene, kSpec, known);
    RoadmapSearch filled(scene, fill);
    for (std::size_t i = 0; i < some; ++i) expect_same(whole, filled, ends[i]);
    EXPECT_TRUE(fill.grew());
    known = through_file(fill.known());
    verify_roadmap(*known);
  }
  RoadmapFill all(scene, kSpec, known);
  RoadmapSearch again(scene, all);
  for (const Ends& one : ends) expect_same(whole, again, one);
  EXPECT_FALSE(all.grew());
  EXPECT_EQ(bytes(all.known()), bytes(*known));
}

// Two that began with the same file, one after the other: what the first wrote is kept.
TEST_P(RoadmapFillProperty, WritersKeepWhatOthersWrote) {
  const auto scene = city(GetParam());
  const auto ends = blocked_ends(scene, GetParam(), 12);
  RoadmapFill one(scene, kSpec);
  RoadmapFill other(scene, kSpec);
  for (int i = 0; i < 12; ++i) {
    RoadmapFill& fill = i % 2 ? one : other;
    RoadmapSearch(scene, fill).search(ends[i].from, ends[i].to, {});
  }
  const Roadmap both = other.known(through_file(one.known()));
  EXPECT_EQ(bytes(both), bytes(one.known(through_file(other.known()))));
  RoadmapFill after(scene, kSpec, through_file(both));
  for (const Ends& e : ends) RoadmapSearch(scene, after).search(e.from, e.to, {});
  EXPECT_FALSE(after.grew());
}

TEST_P(RoadmapFillProperty, ThreadsPlanAtOnce) {
  const auto scene = city(GetParam());
  const auto ends = blocked_ends(scene, GetParam(), 24);
  const Roadmap roadmap = build_roadmap(scene, kSpec, {2, {}});
  Planner by_whole(scene, nullptr, &roadmap);
  RoadmapFill fill(scene, kSpec);
  Planner by_fill(scene, nullptr, fill);
  std::vector<geom::Polyline> paths(ends.size());
  geom::parallel_for(ends.size(), {4, {}}, [&](std::size_t i) {
    paths[i] = by_fill.plan(ends[i].from, ends[i].to).path;
  });
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_EQ(paths[i], by_whole.plan(ends[i].from, ends[i].to).path);
  }
}

INSTANTIATE_TEST_SUITE_P(Cities, RoadmapFillProperty, testing::Values(1, 2, 3));

// Who takes a part for the whole would call far away what is near.
TEST(RoadmapFill, IsNoWholeRoadmap) {
  const auto scene = city(1);
  RoadmapFill fill(scene, kSpec);
  const Ends ends = blocked_ends(scene, 1, 1)[0];
  RoadmapSearch(scene, fill).search(ends.from, ends.to, {});
  const std::string written = bytes(fill.known());
  const auto archive = geom::ArrayArchive::from_bytes(std::as_bytes(std::span(written)), "test");
  EXPECT_THROW(read_roadmap(archive), geom::InputError);
  EXPECT_TRUE(read_roadmap(archive, Filled::allowed).filled);
}

}  // namespace
}  // namespace plan
