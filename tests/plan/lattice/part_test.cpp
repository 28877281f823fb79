#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/lattice/build_lattice.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/lattice_part.h"
#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/roadmap_file.h"
#include "plan/roadmap/roadmap_part.h"
#include "plan/scenes.h"

namespace plan {
namespace {

constexpr std::size_t kCounts[] = {1, 2, 3, 7, 60};  // 60: more than tiles

// As an archive of its own: what a file gives back.
template <class Part>
std::pair<geom::ArrayArchive, std::string> archive_of(const Part& part) {
  const PartArrays arrays = arrays_of(part);
  std::ostringstream out;
  geom::write_array_archive(out, arrays.meta, arrays.arrays);
  const std::string text = out.str();
  return {geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "part"), arrays.meta};
}

LatticePart through_file(const LatticePart& part) {
  const auto [archive, meta] = archive_of(part);
  return read_lattice_part(archive, meta, part.shard);
}

RoadmapPart through_file(const RoadmapPart& part) {
  const auto [archive, meta] = archive_of(part);
  return read_roadmap_part(archive, meta, part.shard);
}

class Parts : public testing::TestWithParam<std::uint64_t> {
 protected:
  geom::CollisionScene scene_ = random_scene(GetParam(), 60, 90, {0.5, 0.5, 0.25});
};

TEST_P(Parts, OfALatticeMakeTheLatticeBitForBit) {
  for (const Connectivity connectivity : {Connectivity::six, Connectivity::twenty_six}) {
    const LatticeSpec spec{1.5, connectivity, {0.1, 0.2, 0.3}};
    const std::string whole = bytes(build_lattice(scene_, spec));
    for (const std::size_t count : kCounts) {
      std::vector<LatticePart> parts;
      for (std::size_t k = 0; k < count; ++k) {
        parts.push_back(through_file(build_lattice_part(scene_, spec, {k, count}, {2, {}})));
      }
      EXPECT_EQ(bytes(join_lattice(parts)), whole) << count << " shards";
      std::ostringstream written;
      write_lattice(written, parts);
      EXPECT_EQ(written.str(), whole) << count << " shards";
    }
  }
}

TEST_P(Parts, OfARoadmapMakeTheRoadmapBitForBit) {
  std::vector<RoadmapSpec> specs(3);
  specs[0].reach = 25;
  specs[1].reach = 500;
  specs[2].reach = 30;
  specs[2].region = geom::Aabb{{20, 10, 0}, {70, 80, 60}};
  for (const RoadmapSpec& spec : specs) {
    const std::string whole = bytes(build_roadmap(scene_, spec));
    for (const std::size_t count : kCounts) {
      std::vector<RoadmapPart> parts;
      for (std::size_t k = 0; k < count; ++k) {
        parts.push_back(through_file(build_roadmap_part(scene_, spec, {k, count}, {2, {}})));
      }
      EXPECT_EQ(bytes(join_roadmap(parts, {2, {}})), whole) << count << " shards";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cities, Parts, testing::Values(1, 2, 3));

std::vector<LatticePart> two_of(const geom::CollisionScene& scene, const LatticeSpec& spec) {
  return {build_lattice_part(scene, spec, {0, 2}), build_lattice_part(scene, spec, {1, 2})};
}

TEST(LatticeParts, OfOtherTilesAreRefused) {
  const auto scene = random_scene(4, 60, 90, {0.5, 0.5, 0.25});
  const auto fine = two_of(scene, {1.5});
  const auto coarse = two_of(scene, {3});
  EXPECT_THROW(join_lattice(std::vector{fine[0], coarse[1]}), geom::InputError);
  const auto third = build_lattice_part(scene, {1.5}, {0, 3});
  EXPECT_THROW(join_lattice(std::vector{fine[0], third}), geom::InputError);
  auto wrong = fine;
  const std::vector<std::uint32_t> records(wrong[1].blocks.record.size(), 1u << 30);
  wrong[1].blocks.record = records;
  EXPECT_THROW(join_lattice(wrong), geom::InputError);
  std::ostringstream written;
  EXPECT_THROW(write_lattice(written, wrong), geom::InputError);
  auto more = fine;
  more[0].blocks.records = more[0].blocks.records.first(more[0].blocks.records.size() / 2);
  EXPECT_THROW(write_lattice(written, more), geom::InputError);
  more = fine;
  const std::vector<std::uint32_t> free(more[0].blocks.record.size(),
                                        0xfffffffe);  // none has a record
  more[0].blocks.record = free;
  EXPECT_THROW(write_lattice(written, more), geom::InputError);
}

std::vector<RoadmapPart> two_of(const geom::CollisionScene& scene, const RoadmapSpec& spec) {
  std::vector<RoadmapPart> parts;
  for (const std::size_t k : {0u, 1u}) parts.push_back(build_roadmap_part(scene, spec, {k, 2}));
  return parts;
}

TEST(RoadmapParts, ThatDoNotFitAreRefused) {
  const auto scene = random_scene(4, 60, 90, {0.5, 0.5, 0.25});
  RoadmapSpec spec;
  spec.reach = 40;
  const auto good = two_of(scene, spec);
  ASSERT_FALSE(good[0].near_box.empty());
  const auto refused = [&](const auto& spoil) {
    auto parts = good;
    spoil(parts);
    EXPECT_THROW(join_roadmap(parts), geom::InputError);
  };
  EXPECT_NO_THROW(join_roadmap(good));
  refused([](auto& parts) { std::swap(parts[0], parts[1]); });
  refused([](auto& parts) { parts[1].boxes = 7; });
  refused([](auto& parts) { ++parts[1].bends_of[0]; });
  refused([](auto& parts) { ++parts[0].near_bends[0]; });
  refused([](auto& parts) { parts[0].near_box[0] = 0xffffffff; });
  const auto with_edge = [](RoadmapPart& part, std::uint32_t to) {
    std::vector<std::vector<std::uint32_t>> lists(part.bends.size());
    for (std::size_t i = 0; i < lists.size(); ++i) {
      lists[i].assign(part.edges.of(i).begin(), part.edges.of(i).end());
    }
    lists[0].push_back(to);
    part.edges = flat(std::move(lists));
  };
  refused([&](auto& parts) { with_edge(parts[0], 0); });
  refused([&](auto& parts) { with_edge(parts[0], 0xfffffffe); });
  refused([](auto& parts) { parts[1].coarse.reset(); });
}

}  // namespace
}  // namespace plan
