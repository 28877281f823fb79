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

std::string told(const Batch& batch) {
  CLI::App app;
  const Common common(app);
  ::testing::internal::CaptureStderr();
  batch.tell(common, "t", "records failed");
  return ::testing::internal::GetCapturedStderr();
}

TEST(Batch, SaysASentenceOfTheFirstThatFailed) {
  Batch one;
  one.add_failed("collision", "a: it touches");
  EXPECT_EQ(told(one), "t: a: it touches\n");
  Batch many;
  for (int i = 0; i < 9; ++i) many.add_failed("collision", std::string(1, 'a' + i) + ": touches");
  EXPECT_EQ(told(many),
            "t: a: touches\nt: b: touches\nt: c: touches\nt: 9 of 9 records failed: 9 collision\n");
  Batch silent;
  silent.add_failed("collision");
  EXPECT_EQ(told(silent), "");
}

}  // namespace
}  // namespace cli
