#include "base/beside.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace geom {
namespace {

TEST(Beside, RunsTasksOneAfterTheOther) {
  for (const std::size_t most : {0, 1, 4}) {
    std::vector<int> done;
    Beside beside(most);
    for (int i = 0; i < 50; ++i) beside.run([&done, i] { done.push_back(i); });
    beside.finish();
    ASSERT_EQ(done.size(), 50u);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
  }
}

TEST(Beside, ThrowsWhatATaskThrowsByTheNextCall) {
  Beside beside(1);
  beside.run([] { throw std::runtime_error("task"); });
  EXPECT_THROW(beside.finish(), std::runtime_error);
  bool ran = false;
  beside.run([] { throw std::runtime_error("task"); });
  EXPECT_THROW(beside.run([&] { ran = true; }), std::runtime_error);
  EXPECT_FALSE(ran);
  EXPECT_NO_THROW(beside.finish());
}

TEST(Beside, RunsNoTaskAfterOneThatThrew) {
  bool ran = false;
  Beside beside(4);
  beside.run([] { throw std::runtime_error("task"); });
  for (int i = 0; i < 3; ++i) beside.run([&] { ran = true; });
  EXPECT_THROW(beside.finish(), std::runtime_error);
  EXPECT_FALSE(ran);
}

TEST(Beside, SaysWhetherATaskWaits) {
  std::promise<void> handed_on;
  std::vector<bool> seen;
  Beside beside(2);
  beside.run([&] {
    handed_on.get_future().wait();
    seen.push_back(beside.is_waited_for());
  });
  beside.run([&] { seen.push_back(beside.is_waited_for()); });
  handed_on.set_value();
  beside.finish();
  EXPECT_EQ(seen, (std::vector{true, false}));
  Beside at_once(0);
  at_once.run([&] { seen.push_back(at_once.is_waited_for()); });
  EXPECT_FALSE(seen.back());
}

TEST(Beside, EndsItsTaskBeforeItself) {
  bool ran = false;
  {
    Beside beside(1);
    beside.run([&] { ran = true; });
  }
  EXPECT_TRUE(ran);
}

}  // namespace
}  // namespace geom
