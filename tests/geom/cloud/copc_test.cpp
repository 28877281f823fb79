#include "geom/cloud/copc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "geom/base/error.h"
#include "support/copc_file.h"

namespace geom {
namespace {

using support::CopcFile;

struct Found {
  std::vector<Vec3> points;
  CopcCounts counts;
};

Found read_part(const std::string& bytes, const CopcPart& part, unsigned threads = 1) {
  Found found;
  const ReadAt read = [&](std::uint64_t at, std::span<unsigned char> to) {
    if (at >= bytes.size()) return std::size_t{0};
    const std::size_t n = std::min(to.size(), bytes.size() - at);
    std::copy_n(bytes.data() + at, n, to.data());
    return n;
  };
  found.counts = read_copc(
      read, "t", [&](const CoordinateReference&) { return part; },
      [&](std::span<const CloudPoint> chunk) {
        for (const CloudPoint& p : chunk) found.points.push_back(p.position);
      },
      {threads, {}});
  return found;
}

std::vector<Vec3> sorted(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return points;
}

std::vector<Vec3> read_all(const std::string& bytes) {
  std::istringstream in(bytes);
  std::vector<Vec3> out;
  read_las(in, "t", [&](std::span<const CloudPoint> chunk) {
    for (const CloudPoint& p : chunk) out.push_back(p.position);
  });
  return out;
}

const std::string& file_bytes() {
  static const std::string bytes = CopcFile::scan(20000, 5, 150).bytes();
  return bytes;
}

TEST(Copc, IsToldByItsFirstBytes) {
  EXPECT_TRUE(is_copc(file_bytes()));
  EXPECT_FALSE(is_copc(file_bytes().substr(0, 400)));
  EXPECT_FALSE(is_copc(support::LazFile{}.bytes()));
  EXPECT_FALSE(is_copc(""));
}

TEST(Copc, WithoutARegionAllPointsAreRead) {
  const Found found = read_part(file_bytes(), {});
  EXPECT_EQ(sorted(found.points), sorted(read_all(file_bytes())));
  EXPECT_EQ(found.counts.all, 20000u);
  EXPECT_EQ(found.counts.outside + found.counts.finer, 0u);
  EXPECT_FALSE(found.counts.spacing);
}

// The points of a region are those that reading all of it finds there, and what is read beside them
// is no more than the cubes that meet it take.
TEST(Copc, OfARegionNoPointIsMissing) {
  const auto all = read_all(file_bytes());
  support::Random random(3);
  for (int i = 0; i < 60; ++i) {
    const double side = random.uniform(5, 400);
    const Vec3 low(random.uniform(-100, 1000), random.uniform(-100, 1000), 0);
    // On points, too: the region is closed.
    const Vec3 corner = i % 4 ? low : all[random.below(all.size())];
    const Aabb region{corner, corner + Vec3(side, side, 0)};
    std::vector<Vec3> expected;
    for (const Vec3& p : all) {
      if (contains(
              {{region.min.x(), region.min.y(), p.z()}, {region.max.x(), region.max.y(), p.z()}},
              p)) {
        expected.push_back(p);
      }
    }
    const Found found = read_part(file_bytes(), {region, 0});
    ASSERT_EQ(sorted(found.points), sorted(expected)) << i;
    ASSERT_EQ(found.counts.outside + expected.size(), all.size()) << i;
  }
}

TEST(Copc, ThreadsChangeNeitherPointsNorCounts) {
  for (const CopcPart& part : {CopcPart{}, CopcPart{Aabb{{200, 200, 0}, {600, 500, 0}}, 5}}) {
    const Found one = read_part(file_bytes(), part);
    for (const unsigned threads : {2u, 7u}) {
      const Found found = read_part(file_bytes(), part, threads);
      EXPECT_EQ(found.points, one.points);
      EXPECT_EQ(found.counts.outside, one.counts.outside);
      EXPECT_EQ(found.counts.finer, one.counts.finer);
      EXPECT_EQ(found.counts.bytes, one.counts.bytes);
      EXPECT_EQ(found.counts.cloud.read, one.counts.cloud.read);
    }
  }
}

TEST(Copc, ASmallRegionTakesFewBytes) {
  const Found found = read_part(file_bytes(), {Aabb{{300, 300, 0}, {340, 340, 0}}, 0});
  EXPECT_GT(found.points.size(), 10u);
  EXPECT_LT(found.counts.bytes, file_bytes().size() / 5);
}

TEST(Copc, AResolutionSaysWhatItLeavesOut) {
  const auto all = read_all(file_bytes());
  const Found coarse = read_part(file_bytes(), {std::nullopt, 5});  // 16, 8, 4 m
  EXPECT_EQ(coarse.counts.spacing, 4.0);
  EXPECT_EQ(coarse.counts.finer + coarse.points.size(), all.size());
  EXPECT_LT(coarse.points.size(), all.size() / 2);
  EXPECT_LT(coarse.counts.bytes, file_bytes().size() / 2);
  const Found fine = read_part(file_bytes(), {std::nullopt, 1e-6});
  EXPECT_EQ(fine.counts.finer, 0u);
  EXPECT_FALSE(fine.counts.spacing);
  EXPECT_EQ(fine.points.size(), all.size());
}

template <class Change>
void expect_refusal(const Change& change, const char* what) {
  const std::string bytes = CopcFile::scan(3000, 7, 100).bytes_with(change);
  // Whatever the region: a claim is found wrong where it is, not where it is asked for.
  EXPECT_THROW(read_part(bytes, {Aabb{{-9, -9, 0}, {-8, -8, 0}}, 0}), InputError) << what;
}

TEST(Copc, RefusesAnOctreeThatForgetsPoints) {
  using Entries = std::vector<CopcFile::Entry>;
  expect_refusal([](Entries& e) { e.pop_back(); }, "the last cube");
  expect_refusal([](Entries& e) { e.erase(e.begin() + 5); }, "a cube between");
  expect_refusal([](Entries& e) { e[3].points -= 1; }, "a point");
  expect_refusal(
      [](Entries& e) {
        e[3].points = 0;
        e[3].bytes = 0;
      },
      "all points of a cube");
  expect_refusal([](Entries& e) { e[3].bytes -= 1; }, "a byte");
  expect_refusal([](Entries& e) { e.push_back(e[2]); }, "a cube twice");
  expect_refusal([](Entries& e) { e[4].points = -7; }, "a count below 0");
  expect_refusal([](Entries& e) { e[4].key[1] = 1 << e[4].key[0]; }, "a cube that is not there");
  expect_refusal([](Entries& e) { e[4].key[0] = 31; }, "too deep a cube");
  expect_refusal([](Entries& e) { e[0] = {e[0].key, 0, 32, -1}; }, "a page that is none");
}

TEST(Copc, RefusesAPageThatLeadsToItself) {
  CopcFile file = CopcFile::scan(3000, 7, 100);
  std::string bytes = file.bytes();
  std::uint64_t root = 0;
  std::memcpy(&root, &bytes[375 + 54 + 40], 8);
  const std::size_t last = root + 32 * file.page;  // the entry that leads on
  std::memcpy(&bytes[last + 16], &root, 8);
  EXPECT_THROW(read_part(bytes, {}), InputError);
}

TEST(Copc, RefusesALaterRecordThatLeadsBack) {
  std::string bytes = file_bytes();
  std::uint64_t at = 0;
  std::memcpy(&at, &bytes[235], 8);
  const std::uint32_t many = 0xFFFFFFFF;
  std::memcpy(&bytes[243], &many, 4);
  const std::uint64_t back = UINT64_MAX - 59;
  std::memcpy(&bytes[at + 20], &back, 8);
  EXPECT_THROW(read_part(bytes, {}), InputError);
}

TEST(Copc, RefusesPointsOutsideTheirCube) {
  CopcFile file = CopcFile::scan(3000, 7, 100);
  file.points.back().x = 90000;
  file.points.back().y = 0;
  for (const unsigned threads : {1u, 3u}) {
    EXPECT_THROW(read_part(file.bytes(), {}, threads), InputError);
  }
}

TEST(Copc, RefusesEveryFileCutShort) {
  const std::string bytes = CopcFile::scan(300, 9, 40).bytes();
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    ASSERT_THROW(read_part(bytes.substr(0, n), {}, n % 16 ? 1 : 3), InputError) << n;
  }
}

TEST(Copc, RefusesARecordThatIsNoCube) {
  for (const double wrong : {0.0, -1.0, 1e300, std::nan("")}) {
    std::string bytes = CopcFile::scan(300, 9, 40).bytes();
    std::memcpy(&bytes[375 + 54 + 24], &wrong, 8);
    EXPECT_THROW(read_part(bytes, {}), InputError) << wrong;
  }
}

}  // namespace
}  // namespace geom
