#include "geom/base/sha256.h"

#include <gtest/gtest.h>

#include <string_view>

namespace geom {
namespace {

std::string sum_of(std::string_view text, std::size_t piece) {
  Sha256 sum;
  for (std::size_t at = 0; at < text.size(); at += piece) {
    sum.update(std::as_bytes(std::span(text.substr(at, piece))));
  }
  return sum.hex();
}

// The examples of FIPS 180-2, appendix B, and the sum of nothing.
TEST(Sha256, GivesTheExamplesOfTheStandard) {
  EXPECT_EQ(sum_of("", 1), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sum_of("abc", 3), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sum_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sum_of(std::string(1000000, 'a'), 1000),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesArrive) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += static_cast<char>(i);
  const std::string whole = sum_of(text, text.size());
  for (const std::size_t piece : {1u, 7u, 63u, 64u, 65u, 128u}) {
    EXPECT_EQ(sum_of(text, piece), whole) << piece;
  }
}

}  // namespace
}  // namespace geom
