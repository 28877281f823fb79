#include "geom/base/random.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

// The first numbers of the authors' reference code for this seed.
TEST(SplitMix64, GivesTheNumbersOfTheReference) {
  SplitMix64 random(1234567);
  for (const std::uint64_t z : {6457827717110365317ull, 3203168211198807973ull,
                                9817491932198370423ull, 4593380528125082431ull}) {
    EXPECT_EQ(random.uniform(0, 1), static_cast<double>(z >> 11) * 0x1p-53);
  }
}

}  // namespace
}  // namespace geom
