#pragma once

// A test's own operator new (own_new.cpp, which the test must link), also that of the libraries
// that it loads. What C code allocates is not looked at.

#include <functional>

namespace support {

// While it lives, operator new number `number` from now on (0: the next one) calls `then` before it
// allocates; where that returns false, it does as it does where malloc gives nothing: it calls the
// handler, if there is one, and throws std::bad_alloc. One at a time.
class AtNew {
 public:
  AtNew(long number, std::function<bool()> then);
  ~AtNew();
  AtNew(const AtNew&) = delete;
  AtNew& operator=(const AtNew&) = delete;

  static bool reached();  // whether the last one called its function
  static long to_go();    // allocations until it does
};

}  // namespace support
