#include "cloud/laz_setup.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "support/reading.h"

namespace geom {
namespace {

using Item = std::array<std::uint16_t, 3>;  // kind, bytes, version

std::string record(std::uint16_t compressor, std::uint32_t chunk, const std::vector<Item>& items) {
  std::string out(34 + 6 * items.size(), '\0');
  const auto count = static_cast<std::uint16_t>(items.size());
  std::memcpy(out.data(), &compressor, 2);
  std::memcpy(out.data() + 12, &chunk, 4);
  std::memcpy(out.data() + 32, &count, 2);
  if (count) std::memcpy(out.data() + 34, items.data(), 6 * items.size());
  return out;
}

std::string refusal(const std::string& data, unsigned format, std::size_t bytes) {
  return support::refusal_of([&] { parse_laz_setup(data, format, bytes, "test"); });
}

TEST(LazSetup, SaysLayoutChunksAndItems) {
  const LazSetup setup =
      parse_laz_setup(record(2, 5000, {{6, 20, 2}, {7, 8, 2}, {0, 3, 2}}), 1, 31, "test");
  EXPECT_EQ(setup.layout, LazSetup::Layout::chunks);
  EXPECT_EQ(setup.chunk_points, 5000u);
  EXPECT_FALSE(setup.chunks_vary());
  ASSERT_EQ(setup.items.size(), 3u);
  EXPECT_EQ(setup.items[2].kind, LazItem::Kind::byte);
  EXPECT_EQ(setup.point_bytes, 31u);
  EXPECT_TRUE(parse_laz_setup(record(3, 0xFFFFFFFF, {{10, 30, 3}}), 6, 30, "test").chunks_vary());
  EXPECT_EQ(parse_laz_setup(record(1, 1, {{6, 20, 1}}), 0, 20, "test").layout,
            LazSetup::Layout::one_stream);
}

TEST(LazSetup, RefusesWhatIsCutShort) {
  const std::string whole = record(2, 5000, {{6, 20, 2}, {7, 8, 2}});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(refusal(whole.substr(0, size), 1, 28), "") << size;
  }
}

TEST(LazSetup, RefusesWhatDoesNotFitOrIsNotRead) {
  EXPECT_NE(refusal(record(2, 0, {{6, 20, 2}}), 0, 20), "");               // empty chunks
  EXPECT_NE(refusal(record(3, 50, {{6, 20, 2}}), 0, 20), "");              // layers of old points
  EXPECT_NE(refusal(record(2, 50, {{10, 30, 3}}), 6, 30), "");             // new points, no layers
  EXPECT_NE(refusal(record(0, 50, {{6, 20, 2}}), 0, 20), "");              // not compressed
  EXPECT_NE(refusal(record(2, 50, {{6, 20, 2}}), 0, 21), "");              // another size
  EXPECT_NE(refusal(record(2, 50, {{6, 21, 2}}), 0, 21), "");              // of one item
  EXPECT_NE(refusal(record(2, 50, {}), 0, 20), "");                        // nothing
  EXPECT_NE(refusal(record(2, 50, {{7, 8, 2}, {6, 20, 2}}), 1, 28), "");   // another order
  EXPECT_NE(refusal(record(2, 50, {{6, 20, 2}, {6, 20, 2}}), 0, 40), "");  // two points
  EXPECT_NE(refusal(record(2, 50, {{6, 20, 2}, {1, 2, 2}}), 0, 22), "");   // an unknown item
  EXPECT_NE(refusal(record(2, 50, {{6, 20, 2}, {0, 0, 2}}), 0, 20), "");   // without bytes
  EXPECT_NE(refusal(record(2, 50, {{6, 20, 3}}), 0, 20), "");              // another version
  EXPECT_TRUE(support::says(refusal(record(3, 50, {{10, 30, 4}}), 6, 30), "version 4"));
}

}  // namespace
}  // namespace geom
