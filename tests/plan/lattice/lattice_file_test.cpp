#include "plan/lattice/lattice_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "plan/file_bytes.h"
#include "plan/lattice/build_lattice.h"
#include "plan/lattice/lattice.h"
#include "plan/scenes.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace plan {
namespace {

Lattice some_lattice(std::uint64_t seed = 1, Connectivity connectivity = Connectivity::twenty_six) {
  const auto scene = random_scene(seed, 8, 18, {0.3, 0.3, 0.3});
  return build_lattice(scene, {1, connectivity, {0.25, 0.5, -100.125}});
}

Lattice read(std::string_view bytes) {
  const auto span = std::as_bytes(std::span(bytes.data(), bytes.size()));
  Lattice lattice = read_lattice(geom::ArrayArchive::from_bytes(span, "test.lattice"));
  verify_lattice(lattice);
  return lattice;
}

void expect_same(const Lattice& a, const Lattice& b) {
  EXPECT_EQ(a.spec().spacing, b.spec().spacing);
  EXPECT_EQ(a.spec().origin, b.spec().origin);
  EXPECT_EQ(a.spec().connectivity, b.spec().connectivity);
  EXPECT_EQ(a.first(), b.first());
  EXPECT_EQ(a.dims(), b.dims());
  EXPECT_EQ(a.made_for().map, b.made_for().map);
  EXPECT_EQ(a.made_for().frame, b.made_for().frame);
  EXPECT_EQ(a.made_for().vehicle, b.made_for().vehicle);
  EXPECT_EQ(a.made_for().margin, b.made_for().margin);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n) ASSERT_EQ(a.mask(n), b.mask(n)) << n;
}

// The file of `lattice` with its arrays or its meta changed, everything else in order.
struct Parts {
  std::string meta;
  std::vector<std::uint32_t> block_record;
  std::vector<std::uint8_t> records;
  std::size_t columns;

  explicit Parts(const Lattice& lattice)
      : columns(lattice.spec().connectivity == Connectivity::six ? 256 : 1024) {
    const std::string file = plan::bytes(lattice);
    const auto span = std::as_bytes(std::span(file.data(), file.size()));
    const auto archive = geom::ArrayArchive::from_bytes(span, "parts");
    const auto copy = [](auto values, auto& to) { to.assign(values.begin(), values.end()); };
    meta = archive.meta();
    copy(archive.array<std::uint32_t>("block_record"), block_record);
    copy(archive.array<std::uint8_t>("records", columns), records);
  }

  std::string bytes() const {
    const geom::NamedArray arrays[] = {
        geom::named_array<std::uint32_t>("block_record", block_record),
        geom::named_array<std::uint8_t>("records", records, columns),
    };
    std::ostringstream out;
    geom::write_array_archive(out, meta, arrays);
    return out.str();
  }

  void replace(const std::string& what, const std::string& by) {
    const auto at = meta.find(what);
    ASSERT_NE(at, std::string::npos) << meta;
    meta.replace(at, what.size(), by);
  }
};

std::string refusal(const Parts& parts) {
  return support::refusal_of([&] { read(parts.bytes()); });
}

TEST(LatticeFileContent, ReadsBackBitForBit) {
  for (const auto connectivity :
       {Connectivity::six, Connectivity::eighteen, Connectivity::twenty_six}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Lattice lattice = some_lattice(seed, connectivity);
      expect_same(lattice, read(bytes(lattice)));
      EXPECT_EQ(bytes(lattice), bytes(read(bytes(lattice))));
    }
  }
}

TEST(LatticeFileContent, StoresNothingForFreeAndBlockedBlocks) {
  const geom::Aabb bounds{{0, 0, 0}, {23, 15, 7}};
  const auto scene = scene_of({{{15.5, -1, -1}, {30, 20, 10}}}, bounds);
  const Lattice lattice = build_lattice(scene, {1, Connectivity::twenty_six, {0, 0, 0}});
  const Parts parts(lattice);
  constexpr std::uint32_t kFree = 0xfffffffe;
  constexpr std::uint32_t kBlocked = 0xffffffff;
  EXPECT_EQ(parts.block_record,
            (std::vector<std::uint32_t>{kFree, 0, kBlocked, kFree, 1, kBlocked}));
  EXPECT_EQ(parts.records.size(), 2 * 1024u);
  expect_same(lattice, read(parts.bytes()));
}

TEST(LatticeFileContent, KeepsIndicesBeyondTheLargestCoordinate) {
  const auto scene = scene_of({}, {{1e6, 0, 0}, {1e6 + 1, 1, 1}});
  const Lattice lattice = build_lattice(scene, {0x1p-8, Connectivity::six, {-1e6, 0.5, 0.5}});
  EXPECT_GT(lattice.first()[0], 100'000'000);
  expect_same(lattice, read(bytes(lattice)));
}

TEST(LatticeFileContent, RefusesAnotherFormatOrVersion) {
  Parts version(some_lattice());
  version.replace("\"version\":2", "\"version\":1");
  EXPECT_TRUE(support::says(refusal(version), "expected lattice version 2, found 1"));
  Parts format(some_lattice());
  format.replace("skyway-lattice", "skyway-boxmap");
  EXPECT_TRUE(support::says(refusal(format), "expected a lattice"));
}

TEST(LatticeFileContent, RefusesMetaThatCannotBe) {
  const std::pair<const char*, const char*> changes[] = {
      {"\"spacing\":1", "\"spacing\":0"},
      {"\"spacing\":1", "\"spacing\":-1"},
      {"\"spacing\":1", "\"spacing\":\"x\""},
      {"\"connectivity\":26", "\"connectivity\":8"},
      {"\"connectivity\":26", "\"connectivity\":6"},
      {"\"dims\":[", "\"dims\":[0"},
      {"\"dims\":[", "\"dims\":[100000"},
      {"\"dims\":[", "\"dims\":[-"},
      {"\"dims\":[", "\"dims\":[0.5,"},
      {"\"dims\":", "\"sizes\":"},
      {"\"first\":[", "\"first\":[1e300,"},
      {"\"first\":[", "\"first\":[0."},
      {"\"first\":", "\"last\":"},
      {"\"origin\":", "\"other\":"},
  };
  for (const auto& [what, by] : changes) {
    Parts parts(some_lattice());
    parts.replace(what, by);
    EXPECT_NE(refusal(parts), "") << what << " -> " << by;
  }
}

TEST(LatticeFileContent, RefusesArraysOfTheWrongLength) {
  Parts few(some_lattice());
  few.block_record.pop_back();
  EXPECT_NE(refusal(few), "");
  Parts records(some_lattice());
  records.records.resize(records.records.size() - 1024);
  EXPECT_NE(refusal(records), "");
  Parts more(some_lattice());
  more.records.resize(more.records.size() + 1024);
  EXPECT_NE(refusal(more), "");
  Parts number(some_lattice());
  number.block_record[0] = 1000;
  EXPECT_NE(refusal(number), "");
}

TEST(LatticeFileContent, RefusesAnEdgeToABlockedNode) {
  Parts parts(some_lattice());
  std::size_t at = 0;  // a node with all edges
  while (parts.records[at] != 0xff || parts.records[at + 1] != 0x3f) at += 2;
  parts.records[at + 2] = parts.records[at + 3] = 0;  // its x neighbour
  EXPECT_TRUE(support::says(refusal(parts), "blocked node"));
}

TEST(LatticeFileContent, RefusesCountsThatAreNotTheLattices) {
  Parts parts(some_lattice());
  parts.replace("\"nodes\":", "\"nodes\":1");
  EXPECT_TRUE(support::says(refusal(parts), "expected"));
}

// No bit is ignored: a changed one is refused, or comes out again.
TEST(LatticeFileContent, RefusesOrKeepsEveryFlippedBit) {
  for (const auto connectivity : {Connectivity::six, Connectivity::twenty_six}) {
    const Parts good(some_lattice(1, connectivity));
    std::size_t refused = 0;
    for (std::size_t i = 0; i < good.records.size(); i += 37) {
      Parts bad = good;
      bad.records[i] ^= static_cast<std::uint8_t>(1u << (i % 8));
      try {
        EXPECT_EQ(Parts(read(bad.bytes())).records, bad.records);
      } catch (const geom::InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 0u);
  }
}

TEST(LatticeFileContent, RefusesEveryTruncation) {
  const std::string file = bytes(some_lattice());
  for (std::size_t n = 0; n < file.size(); n += n < 512 ? 1 : 257) {
    EXPECT_THROW(read(std::string_view(file).substr(0, n)), geom::InputError) << n;
  }
}

TEST(LatticeFileContent, SurvivesFlippedBytesAnywhere) {
  const std::string good = bytes(some_lattice());
  support::Random random(4);
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bad = good;
    // Half of the flips where the directory and the headers are.
    const int n = static_cast<int>(bad.size());
    const int at = i % 2   ? random.below(n)
                   : i % 4 ? random.below(1024)
                           : n - 1 - random.below(1024);
    bad[static_cast<std::size_t>(at)] ^= static_cast<char>(1 << random.below(8));
    try {
      const Lattice lattice = read(bad);
      for (std::size_t k = 0; k < lattice.size(); ++k) {
        const std::uint32_t mask = lattice.mask(k);
        for (int d = 0; d < kDirections; ++d) {
          if (!(mask >> d & 1)) continue;
          const auto other =
              static_cast<std::size_t>(static_cast<std::int64_t>(k) + lattice.offset(d));
          ASSERT_LT(other, lattice.size());
          ASSERT_TRUE((mask & Lattice::kNode) && lattice.free(other));
        }
      }
    } catch (const geom::InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500u);
}

}  // namespace
}  // namespace plan
