#include "cli/batch.h"

#include <gtest/gtest.h>

namespace cli {
namespace {

TEST(Batch, SaysHowManyFailedAndWhyTheMostFrequentFirst) {
  Batch batch;
  batch.add_failed("unreachable");
  for (int i = 0; i < 2; ++i) batch.add_failed("goal_blocked");
  batch.add_good();
  EXPECT_EQ(batch.text("queries have no path"),
            "3 of 4 queries have no path: 2 goal_blocked, 1 unreachable");
}

TEST(Batch, SaysNothingWhereAllAreGoodOrThereIsOneAlone) {
  Batch batch;
  EXPECT_EQ(batch.text("records failed"), "");
  batch.add_failed("collision");
  EXPECT_EQ(batch.text("records failed"), "");
  Batch good;
  for (int i = 0; i < 3; ++i) good.add_good();
  EXPECT_EQ(good.text("records failed"), "");
}

}  // namespace
}  // namespace cli
