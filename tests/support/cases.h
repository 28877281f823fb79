#pragma once

// How many random cases a property test tries.

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace support {

// `usual`, or as many times that as SKYWAY_CASES says, for long runs by hand.
inline int cases(int usual) {
  const char* const text = std::getenv("SKYWAY_CASES");
  int times = 1;
  if (text) std::from_chars(text, text + std::strlen(text), times);
  return usual * times;
}

}  // namespace support
