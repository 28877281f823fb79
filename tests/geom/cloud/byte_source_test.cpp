#include "cloud/byte_source.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"

namespace geom {
namespace {

std::string numbered(std::size_t size) {
  std::string out(size, '\0');
  for (std::size_t i = 0; i < size; ++i) out[i] = static_cast<char>(i * 7 % 251);
  return out;
}

TEST(ByteSource, HandsOutAStreamInOrderWhateverTheWay) {
  const std::string all = numbered(300000);
  std::istringstream in(all);
  ByteSource bytes(in, 1000, "test");
  EXPECT_EQ(bytes.next(), static_cast<unsigned char>(all[0]));
  std::vector<unsigned char> some;
  bytes.read(100000, some);
  EXPECT_EQ(some.back(), static_cast<unsigned char>(all[100000]));
  EXPECT_EQ(bytes.skip(99999), 99999u);
  EXPECT_EQ(bytes.position(), 1000u + 200000);
  EXPECT_EQ(bytes.next(), static_cast<unsigned char>(all[200000]));
  const auto rest = bytes.load();
  EXPECT_EQ(rest.size(), all.size() - 200001);
  EXPECT_EQ(bytes.position(), 1000u + 200001);
  EXPECT_EQ(bytes.next(), static_cast<unsigned char>(all[200001]));
}

TEST(ByteSource, ReadsNumbersLittleEndian) {
  const unsigned char raw[] = {1, 2, 0, 0, 0xFE, 0xFF, 0xFF, 0xFF};
  ByteSource bytes(raw, 0, "test");
  EXPECT_EQ(bytes.number<std::uint32_t>(), 513u);
  EXPECT_EQ(bytes.number<std::int32_t>(), -2);
}

// A count of the file takes no memory that the file has no bytes for.
TEST(ByteSource, EndsWhereTheBytesEnd) {
  std::istringstream in(numbered(10));
  ByteSource bytes(in, 0, "test");
  std::vector<unsigned char> to;
  EXPECT_THROW(bytes.read(std::uint64_t{1} << 60, to), InputError);
  EXPECT_EQ(to.size(), 10u);
  EXPECT_EQ(bytes.skip(5), 0u);
  unsigned char some[4];
  EXPECT_EQ(bytes.copy(some), 0u);
  EXPECT_THROW(bytes.next(), InputError);
}

}  // namespace
}  // namespace geom
