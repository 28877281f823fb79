#include "base/beside.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace geom {
namespace {

TEST(Beside, RunsTasksOneAfterTheOther) {
  for (const bool alone : {true, false}) {
    std::vector<int> done;
    Beside beside(alone);
    for (int i = 0; i < 50; ++i) beside.run([&done, i] { done.push_back(i); });
    beside.finish();
    ASSERT_EQ(done.size(), 50u);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
  }
}

TEST(Beside, ThrowsWhatATaskThrowsByTheNextCall) {
  Beside beside(false);
  beside.run([] { throw std::runtime_error("task"); });
  EXPECT_THROW(beside.finish(), std::runtime_error);
  bool ran = false;
  beside.run([] { throw std::runtime_error("task"); });
  EXPECT_THROW(beside.run([&] { ran = true; }), std::runtime_error);
  EXPECT_FALSE(ran);
  EXPECT_NO_THROW(beside.finish());
}

TEST(Beside, EndsItsTaskBeforeItself) {
  bool ran = false;
  {
    Beside beside(false);
    beside.run([&] { ran = true; });
  }
  EXPECT_TRUE(ran);
}

}  // namespace
}  // namespace geom
