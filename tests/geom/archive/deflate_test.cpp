#include "geom/archive/deflate.h"

#include <gtest/gtest.h>

#include "archive/inflate.h"
#include "support/random_city.h"

namespace geom {
namespace {

TEST(Deflated, IsReadBack) {
  support::Random random(5);
  for (const std::size_t size : {0u, 1u, 100u, 70000u, 300000u}) {
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(random.below(size < 80000 ? 256 : 3));
    const std::string small = deflated(std::as_bytes(std::span(bytes)));
    EXPECT_EQ(inflated(std::as_bytes(std::span(small)), size), bytes) << size;
    if (size == 300000) {
      EXPECT_LT(small.size(), size / 3);
    }
  }
}

}  // namespace
}  // namespace geom
