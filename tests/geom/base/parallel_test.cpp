#include "geom/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace geom {
namespace {

// What was thrown for the items, and how many were begun.
TEST(ParallelFor, ThrowsWhatAnItemThrewWhateverTheThreads) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    std::atomic<int> begun = 0;
    try {
      parallel_for(100000, {threads, {}}, [&](std::size_t i) {
        ++begun;
        if (i == 10) throw std::runtime_error("item " + std::to_string(i));
      });
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "item 10");
    }
    EXPECT_LT(begun, 100000);
  }
}

TEST(ParallelFor, ThrowsWhatTheProgressReportThrew) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    const auto progress = [](std::size_t done, std::size_t) {
      if (done == 3) throw std::runtime_error("closed");
    };
    EXPECT_THROW(parallel_for(1000, {threads, progress}, [](std::size_t) {}), std::runtime_error);
  }
}

TEST(ForWork, GivesEachThreadEnough) {
  const auto threads = [](unsigned threads, std::uint64_t work) {
    return for_work({threads, {}}, work, 100).threads;
  };
  EXPECT_EQ(threads(8, 0), 1u);
  EXPECT_EQ(threads(8, 199), 1u);
  EXPECT_EQ(threads(8, 200), 2u);
  EXPECT_EQ(threads(8, 1'000'000'000'000), 8u);
  EXPECT_EQ(threads(1, 1'000'000'000'000), 1u);
  EXPECT_EQ(threads(0, 200), 1u);
}

}  // namespace
}  // namespace geom
