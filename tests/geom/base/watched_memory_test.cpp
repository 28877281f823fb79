#include "base/watched_memory.h"

#include <gtest/gtest.h>

#include <new>

namespace geom {
namespace {

// What operator new does where malloc gives nothing.
void fail_to_allocate() {
  const std::new_handler handler = std::get_new_handler();
  ASSERT_TRUE(handler);
  EXPECT_THROW(handler(), std::bad_alloc);
}

TEST(WatchedMemory, TellsOfFailuresSinceItWasMade) {
  const WatchedMemory outer;
  EXPECT_NO_THROW(outer.require_enough());
  fail_to_allocate();
  EXPECT_THROW(outer.require_enough(), std::bad_alloc);
  const WatchedMemory inner;
  EXPECT_NO_THROW(inner.require_enough());
  fail_to_allocate();
  EXPECT_THROW(inner.require_enough(), std::bad_alloc);
}

bool called = false;
void note_call() {
  called = true;
  throw std::bad_alloc();
}

TEST(WatchedMemory, CallsTheHandlerThatWasThere) {
  const std::new_handler before = std::set_new_handler(note_call);
  {
    const WatchedMemory watched;
    fail_to_allocate();
    EXPECT_TRUE(called);
    EXPECT_THROW(watched.require_enough(), std::bad_alloc);
  }
  EXPECT_EQ(std::get_new_handler(), &note_call);
  std::set_new_handler(before);
}

}  // namespace
}  // namespace geom
