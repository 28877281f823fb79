#pragma once

// Texts given to readers, and what is said of them.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>

#include "geom/base/error.h"

namespace support {

// A text as the stream of the call that it stands in.
class Text {
 public:
  explicit Text(const std::string& text) : in_(text) {}
  operator std::istream&() && { return in_; }

 private:
  std::istringstream in_;
};

// The message of the InputError that f() throws; empty where it throws none.
template <class F>
std::string refusal_of(const F& f) {
  try {
    f();
  } catch (const geom::InputError& error) {
    return error.what();
  }
  return "";
}

// Whether these words stand in the text; shows both.
inline testing::AssertionResult says(std::string_view text, std::string_view words) {
  const bool found = text.find(words) != text.npos;
  return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "\"" << words << "\" is " << (found ? "" : "not ") << "in: " << text;
}

}  // namespace support
