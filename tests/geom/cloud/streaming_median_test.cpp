#include "cloud/streaming_median.h"

#include <gtest/gtest.h>

#include "support/laz_encoders.h"

namespace geom {
namespace {

TEST(StreamingMedian, IsZeroAtFirst) { EXPECT_EQ(StreamingMedian().get(), 0); }

// Against the same rule said by sorting.
TEST(StreamingMedian, DrivesOutTheLargestOrTheSmallest) {
  support::Random random(1);
  StreamingMedian median;
  support::EncoderMedian sorted;
  for (int i = 0; i < 20000; ++i) {
    const std::int32_t v = random.below(i % 100 < 50 ? 9 : 100000) - 4;
    median.add(v);
    sorted.add(v);
    ASSERT_EQ(median.get(), sorted.v[2]) << i;
  }
}

TEST(StreamingMedian, FollowsASequenceThatRises) {
  StreamingMedian median;
  for (const std::int32_t v : {10, 20, 30, 40, 50, 60, 70}) median.add(v);
  EXPECT_GE(median.get(), 30);
}

}  // namespace
}  // namespace geom
