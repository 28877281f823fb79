#include "geom/archive/array_archive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <numeric>
#include <sstream>

#include "geom/base/error.h"
#include "support/edited_map.h"
#include "support/reading.h"

namespace geom {
namespace {

// Small arrays of these names, one after the other.
std::vector<std::byte> archive_of(const std::vector<std::string>& names) {
  const std::vector<std::uint8_t> values = {1, 2, 3};
  std::vector<NamedArray> arrays;
  for (const std::string& name : names) {
    arrays.push_back(named_array<std::uint8_t>(name, std::span(values)));
  }
  std::ostringstream out;
  write_array_archive(out, "{}", arrays);
  return support::bytes_of(out.str());
}

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("a" + std::to_string(i));
  return names;
}

TEST(ArrayArchive, ReadsManyEntriesInATimeThatGrowsWithTheirNumber) {
  const auto least_time = [](std::size_t entries) {
    const auto bytes = archive_of(numbered(entries));
    std::clock_t least = std::numeric_limits<std::clock_t>::max();
    for (int i = 0; i < 3; ++i) {
      const std::clock_t begin = std::clock();  // of the process, so that others do not matter
      EXPECT_EQ(ArrayArchive::from_bytes(bytes, "a").arrays().size(), entries);
      least = std::min(least, std::clock() - begin);
    }
    return static_cast<double>(least);
  };
  // Eight times the entries: eight times the time, or sixty-four if each looked at all others.
  EXPECT_LT(least_time(48000), 24 * least_time(6000));
}

TEST(ArrayArchive, HasTheDirectoryHashOfWhatItHolds) {
  const auto hash = [](std::string_view meta, std::uint8_t last) {
    const std::vector<std::uint8_t> values = {1, 2, last};
    const std::vector arrays = {named_array<std::uint8_t>("a", std::span(values))};
    std::ostringstream out;
    write_array_archive(out, meta, arrays);
    return ArrayArchive::from_bytes(support::bytes_of(out.str()), "a").directory_hash();
  };
  EXPECT_EQ(hash("{}", 3), hash("{}", 3));
  EXPECT_NE(hash("{}", 3), hash("{}", 4));
  EXPECT_NE(hash("{}", 3), hash("{ }", 3));
}

TEST(ArrayArchive, RefusesADirectoryOfMoreEntriesThanAnyFileOfOurs) {
  const auto bytes = archive_of(numbered(300000));
  const std::string message = support::refusal_of([&] { ArrayArchive::from_bytes(bytes, "a"); });
  EXPECT_TRUE(support::says(message, "at most 65536 entries, found 300001"));
}

TEST(ArrayArchive, RefusesANameThatComesTwice) {
  auto names = numbered(500);
  names[400] = names[7];
  const auto bytes = archive_of(names);
  const std::string message = support::refusal_of([&] { ArrayArchive::from_bytes(bytes, "a"); });
  EXPECT_TRUE(support::says(message, "a7.npy: expected each entry once"));
}

TEST(ArrayArchive, ShowsNamesOfEntriesShortAndWithoutControlBytes) {
  const std::string name = "\x1b[2J" + std::string(5000, 'x');
  const auto bytes = archive_of({name, name});
  const std::string message = support::refusal_of([&] { ArrayArchive::from_bytes(bytes, "a"); });
  EXPECT_TRUE(support::says(message, "found it twice"));
  EXPECT_FALSE(support::says(message, "\x1b"));
  EXPECT_LT(message.size(), 200u);
}

TEST(ArrayArchive, RefusesEntriesThatOverlap) {
  // The directory's second entry (after meta.json) is pointed at the third, of the same name
  // length.
  auto bytes = archive_of({"a", "b"});
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t at = text.rfind("PK\x01\x02", text.rfind("b.npy"));
  const std::size_t before = text.rfind("PK\x01\x02", at - 1);
  ASSERT_NE(before, std::string::npos);
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 42, 4,
              bytes.begin() + static_cast<std::ptrdiff_t>(before) + 42);
  EXPECT_THROW(ArrayArchive::from_bytes(bytes, "a"), InputError);
}

TEST(ArrayArchive, VerifiesWhatSpansManyStretchesOnAnyThreads) {
  std::vector<std::uint64_t> values(3 << 20);  // 24 MB
  std::iota(values.begin(), values.end(), 0);
  const NamedArray arrays[] = {named_array<std::uint64_t>("v", std::span(values))};
  std::ostringstream out;
  write_array_archive(out, "{}", arrays);
  auto bytes = support::bytes_of(out.str());
  for (const unsigned threads : {1u, 3u}) {
    EXPECT_NO_THROW(ArrayArchive::from_bytes(bytes, "a").verify({threads, {}}));
  }
  for (const std::size_t at : {std::size_t{1000}, bytes.size() / 2, bytes.size() - 1000}) {
    auto damaged = bytes;
    damaged[at] ^= std::byte{16};
    for (const unsigned threads : {1u, 3u}) {
      const auto archive = ArrayArchive::from_bytes(damaged, "a");
      EXPECT_THROW(archive.verify({threads, {}}), InputError) << at;
    }
  }
}

}  // namespace
}  // namespace geom
