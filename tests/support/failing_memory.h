#pragma once

// A test's own malloc (failing_memory.cpp, which the test must link), that fails when it is told
// to.

namespace support {

// While it lives, allocation number `first` from now on (0: the next one) fails, in whatever thread
// and library: C++, C, and pages from the system. One at a time.
class FailingMemory {
 public:
  enum class Then {
    works,  // again: memory was short for a moment
    fails   // until this object ends: memory is used up
  };

  FailingMemory(long first, Then then);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  static bool any_failed();  // since the last one began
};

}  // namespace support
