#include "plan/lattice/lattice_part.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/lattice/build_lattice.h"
#include "plan/lattice/lattice_file.h"
#include "plan/scenes.h"
#include "plan/through_file.h"

namespace plan {
namespace {

constexpr std::size_t kCounts[] = {1, 2, 3, 7, 60};  // 60: more than tiles

class LatticePartsProperty : public testing::TestWithParam<std::uint64_t> {
 protected:
  geom::CollisionScene scene_ = random_scene(GetParam(), 60, 90, {0.5, 0.5, 0.25});
};

TEST_P(LatticePartsProperty, MakeTheLatticeBitForBit) {
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

INSTANTIATE_TEST_SUITE_P(Cities, LatticePartsProperty, testing::Values(1, 2, 3));

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

}  // namespace
}  // namespace plan
