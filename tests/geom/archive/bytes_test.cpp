#include "geom/archive/bytes.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace geom {
namespace {

TEST(AppendBytes, AreLittleEndianAndInTheWidthOfTheType) {
  std::string bytes = "x";
  append_bytes(bytes, std::uint32_t{0x01020304});
  append_bytes(bytes, std::int16_t{-2});
  append_bytes(bytes, 1.0);
  EXPECT_EQ(bytes, std::string("x\x04\x03\x02\x01\xfe\xff\0\0\0\0\0\0\xf0\x3f", 15));
}

}  // namespace
}  // namespace geom
