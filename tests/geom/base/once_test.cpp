#include "geom/base/once.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace geom {
namespace {

TEST(Once, TriesAgainWhatThrew) {
  Once once;
  int tries = 0;
  const auto second_time = [&] {
    if (++tries == 1) throw std::runtime_error("first");
  };
  EXPECT_THROW(once.call(second_time), std::runtime_error);
  once.call(second_time);
  once.call(second_time);
  EXPECT_EQ(tries, 2);
}

TEST(Once, IsDoneWhenAnyOfManyReturns) {
  for (int round = 0; round < 50; ++round) {
    Once once;
    int made = 0;
    std::vector<std::thread> threads;
    std::vector<int> seen(8);
    for (int& value : seen) {
      threads.emplace_back([&once, &made, &value] {
        once.call([&] { ++made; });
        value = made;
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(seen, std::vector<int>(8, 1));
  }
}

}  // namespace
}  // namespace geom
