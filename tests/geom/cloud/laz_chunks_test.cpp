#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "geom/base/error.h"
#include "geom/cloud/point_cloud.h"
#include "support/laz_file.h"

namespace geom {
namespace {

using support::LazFile;
using Layout = LazFile::Layout;

// What a reading gives: points, or why there are none.
struct Reading {
  std::vector<CloudPoint> points;
  std::string refusal;
};

Reading read(const std::string& bytes, const LasReading& how) {
  std::istringstream in(bytes);
  Reading out;
  try {
    read_las(
        in, "test.laz",
        [&](std::span<const CloudPoint> chunk) {
          out.points.insert(out.points.end(), chunk.begin(), chunk.end());
        },
        {}, how);
  } catch (const InputError& error) {
    out.refusal = error.what();
  }
  return out;
}

ReadAt way_into(const std::string& bytes) {
  return [&](std::uint64_t at, std::span<unsigned char> to) {
    const std::size_t from = std::min<std::uint64_t>(at, bytes.size());
    const std::size_t n = std::min(to.size(), bytes.size() - from);
    std::copy_n(bytes.data() + from, n, to.data());
    return n;
  };
}

void expect_equal(const Reading& a, const Reading& b, const std::string& what) {
  ASSERT_EQ(a.points.size(), b.points.size()) << what;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    ASSERT_EQ(a.points[i].position, b.points[i].position) << what << ", point " << i;
    ASSERT_EQ(a.points[i].cls, b.points[i].cls) << what << ", point " << i;
  }
}

// What all ways to read the bytes come to: one thread or three, with a second way into the file or
// without one.
Reading read(const std::string& bytes) {
  const Reading front_to_back = read(bytes, {});
  const Reading ahead = read(bytes, {{1, {}}, way_into(bytes)});
  EXPECT_EQ(front_to_back.refusal.empty(), ahead.refusal.empty());
  for (const LasReading& how : {LasReading{{3, {}}, {}}, LasReading{{3, {}}, way_into(bytes)}}) {
    const Reading& one = how.ahead ? ahead : front_to_back;
    const Reading three = read(bytes, how);
    EXPECT_EQ(three.refusal, one.refusal);
    if (one.refusal.empty()) expect_equal(three, front_to_back, "three threads");
  }
  return ahead;
}

// What read_las says of the bytes; "" where it reads them.
std::string refusal(const std::string& bytes) { return read(bytes).refusal; }

void expect_points(const LazFile& file, const std::string& what) {
  const Reading reading = read(file.bytes());
  ASSERT_EQ(reading.refusal, "") << what;
  const std::vector<CloudPoint>& found = reading.points;
  ASSERT_EQ(found.size(), file.points.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const support::LazFilePoint& p = file.points[i];
    ASSERT_EQ(found[i].position, Vec3(p.x, p.y, p.z) * file.scale) << what << ", point " << i;
    ASSERT_EQ(found[i].cls, p.cls) << what << ", point " << i;
  }
}

LazFile file_of(unsigned format, std::size_t points, std::uint64_t seed = 1) {
  LazFile file;
  file.format = format;
  file.scale = 0.001;
  file.points = LazFile::scan(points, seed, format >= 6);
  return file;
}

TEST(Laz, ReadsEveryFormatVersionAndLayout) {
  for (unsigned format = 0; format <= 10; ++format) {
    for (const unsigned version : {1u, 2u}) {
      for (const Layout layout : {Layout::one_stream, Layout::fixed, Layout::varying}) {
        if (format >= 6 && (version == 1 || layout == Layout::one_stream)) continue;
        for (const unsigned extra : {0u, 3u}) {
          LazFile file = file_of(format, 2000, format + 1);
          file.version = version;
          file.layout = layout;
          file.chunk = 700;
          file.extra = extra;
          expect_points(file, "format " + std::to_string(format) + ", version " +
                                  std::to_string(version) + ", layout " +
                                  std::to_string(static_cast<int>(layout)) + ", extra bytes " +
                                  std::to_string(extra));
        }
      }
    }
  }
}

TEST(Laz, ReadsChunksOfOnePointAndNone) {
  for (const unsigned format : {0u, 3u, 6u, 7u}) {
    for (const std::size_t points : {0u, 1u, 2u, 7u}) {
      LazFile file = file_of(format, points);
      file.chunk = 1;
      expect_points(file, "format " + std::to_string(format));
    }
  }
}

TEST(Laz, ReadsATableWhosePlaceStandsAfterIt) {
  for (const unsigned format : {3u, 7u}) {
    for (const Layout layout : {Layout::fixed, Layout::varying}) {
      LazFile file = file_of(format, 300);
      file.layout = layout;
      file.table_place_at_end = true;
      expect_points(file, "format " + std::to_string(format));
    }
  }
}

TEST(Laz, ReadsLayersThatChangeNothing) {
  LazFile file = file_of(6, 300);
  for (support::LazFilePoint& p : file.points) {
    p.z = 5;
    p.cls = 6;
  }
  expect_points(file, "flat, of one class");
}

TEST(Laz, ReadsTheMostUsualPointAsOftenAsItComes) {
  for (const unsigned format : {0u, 6u}) {
    LazFile file = file_of(format, 1);
    file.points.resize(60000, file.points.front());
    file.chunk = 50000;
    expect_points(file, "format " + std::to_string(format));
  }
}

// Wherever a file ends too early, it is refused.
TEST(Laz, RefusesEveryFileCutShort) {
  for (const unsigned format : {0u, 3u, 6u, 8u}) {
    for (const Layout layout : {Layout::one_stream, Layout::fixed, Layout::varying}) {
      if (format >= 6 && layout == Layout::one_stream) continue;
      LazFile file = file_of(format, 120);
      file.layout = layout;
      const std::string whole = file.bytes();
      for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string cut = whole.substr(0, size);
        const LasReading how{{1 + static_cast<unsigned>(size % 16 == 0), {}},
                             size % 2 ? way_into(cut) : ReadAt()};
        EXPECT_NE(read(cut, how).refusal, "") << "format " << format << ", " << size;
      }
    }
  }
}

// No count but the true one fits the bytes of chunks.
TEST(Laz, RefusesCountsThatDoNotFit) {
  for (const unsigned format : {0u, 3u, 7u}) {
    for (const Layout layout : {Layout::fixed, Layout::varying}) {
      LazFile file = file_of(format, 120);
      file.layout = layout;
      const std::string whole = file.bytes();
      for (const std::uint32_t count :
           {1u, 49u, 50u, 51u, 100u, 113u, 119u, 121u, 127u, 150u, 4000000000u}) {
        std::string changed = whole;
        std::memcpy(changed.data() + 107, &count, 4);
        if (format >= 6) std::memset(changed.data() + 247, 0, 8);
        EXPECT_NE(refusal(changed), "") << "format " << format << ", " << count;
      }
    }
  }
}

TEST(Laz, RefusesWhatFollowsItsPoints) {
  for (const Layout layout : {Layout::one_stream, Layout::fixed, Layout::varying}) {
    LazFile file = file_of(3, 120);
    file.layout = layout;
    const std::string whole = file.bytes();
    EXPECT_EQ(refusal(whole), "");
    EXPECT_NE(refusal(whole + whole), "") << "one file behind another";
    if (layout == Layout::one_stream) {
      EXPECT_NE(refusal(whole + '\0'), "");
    }
  }
}

// A record of GeoTIFF keys as it stands after the points.
std::string later_keys() {
  std::string out("\0\0LASF_Projection\0\xaf\x87\x08", 21);
  out.resize(60);
  return out + std::string("\x01\0\x01\0\0\0\0\0", 8);
}

TEST(Laz, RefusesAReferenceBehindItsPointsThatTheHeaderDoesNotCount) {
  const std::string refused = refusal(file_of(3, 120).bytes() + later_keys());
  EXPECT_NE(refused.find("its reference system stands after its points"), refused.npos) << refused;
}

// Where a file's points begin, with the place of its table of chunks.
std::size_t data_of(const std::string& file) {
  std::uint32_t data = 0;
  std::memcpy(&data, file.data() + 96, 4);
  return data;
}

std::uint64_t table_of(const std::string& file) {
  std::uint64_t table = 0;
  std::memcpy(&table, file.data() + data_of(file), 8);
  return table;
}

// The file with a byte of its table changed: of its version, its count, and its code.
std::vector<std::string> other_tables(const std::string& file) {
  std::vector<std::string> out;
  for (const std::size_t at : {0u, 3u, 4u, 7u, 8u, 9u, 11u}) {
    char& byte = out.emplace_back(file)[table_of(file) + at];
    byte = static_cast<char>(byte ^ 0x11);
  }
  return out;
}

TEST(Laz, RefusesATableThatIsElsewhere) {
  for (const unsigned format : {0u, 7u}) {
    for (const Layout layout : {Layout::fixed, Layout::varying}) {
      LazFile file = file_of(format, 120);
      file.layout = layout;
      const std::string whole = file.bytes();
      const std::size_t data = data_of(whole);
      const std::uint64_t right = table_of(whole);
      for (const std::uint64_t place :
           {std::uint64_t{0}, std::uint64_t{1}, right - 1, right + 1, right + 10, right + 4000,
            std::uint64_t{1} << 40, ~std::uint64_t{0} >> 1, ~std::uint64_t{0}}) {
        std::string changed = whole;
        std::memcpy(changed.data() + data, &place, 8);
        EXPECT_NE(refusal(changed), "") << "format " << format << ", " << place;
      }
    }
  }
}

TEST(Laz, RefusesATableThatContradictsItsChunks) {
  const std::string whole = file_of(3, 300).bytes();
  for (const std::string& changed : other_tables(whole)) {
    EXPECT_NE(refusal(changed), "");
  }
}

TEST(Laz, RefusesLayersLongerOrShorterThanTheirPoints) {
  const LazFile file = file_of(6, 40);
  const std::string whole = file.bytes();
  const std::size_t sizes = data_of(whole) + 8 + file.record_size() + 4;
  for (const std::size_t layer : {0u, 1u, 2u, 4u, 8u}) {
    for (const std::uint32_t size : {0u, 5u, 3000u, 0xFFFFFFFFu}) {
      std::string changed = whole;
      std::memcpy(changed.data() + sizes + 4 * layer, &size, 4);
      EXPECT_NE(refusal(changed), "") << "layer " << layer << ", " << size;
    }
  }
}

TEST(Laz, SaysWhatIsWrong) {
  LazFile file = file_of(0, 120);
  std::string whole = file.bytes();
  EXPECT_NE(refusal(whole.substr(0, whole.size() - 60)).find("cut short"), std::string::npos);
  std::string unnamed = whole;
  unnamed[227 + 2] = 'x';
  EXPECT_NE(refusal(unnamed).find("no record \"laszip encoded\""), std::string::npos);
  std::string wide = whole;
  wide[105] = 21;
  EXPECT_NE(refusal(wide).find("21 bytes a point, and its items have 20"), std::string::npos);
}

// The table is looked at before its turn, and the file may be another then.
TEST(Laz, ATableSeenAheadIsHeldAgainstTheOneInItsPlace) {
  LazFile file = file_of(3, 300);
  file.chunk = 50;
  const std::string whole = file.bytes();
  for (const std::string& changed : other_tables(whole)) {
    EXPECT_NE(read(changed, {{2, {}}, way_into(whole)}).refusal, "");
    // What is seen ahead alone is wrong: the file is right, or one of its chunks is not as long.
    const Reading reading = read(whole, {{2, {}}, way_into(changed)});
    if (reading.refusal.empty()) expect_equal(reading, read(whole, {}), "another table");
  }
}

TEST(Laz, AWayIntoTheFileThatLeadsNowhereChangesNothing) {
  const std::string whole = file_of(3, 300).bytes();
  const ReadAt nowhere = [](std::uint64_t, std::span<unsigned char>) { return std::size_t{0}; };
  const Reading reading = read(whole, {{2, {}}, nowhere});
  EXPECT_EQ(reading.refusal, "");
  expect_equal(reading, read(whole, {}), "no table");
}

// Of chunks too large to be held when they are decoded, points come as of small ones.
TEST(Laz, ReadsVeryLargeChunks) {
  for (const unsigned format : {0u, 6u}) {
    LazFile file = file_of(format, 264000);
    file.layout = format == 0 ? Layout::fixed : Layout::varying;
    file.chunk = 263000;
    if (format == 6) file.sizes = {263000, 1000};
    expect_points(file, "format " + std::to_string(format));
  }
}

}  // namespace
}  // namespace geom
