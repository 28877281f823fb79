#pragma once

// The exception for options that contradict each other, or what a file turns out to hold.

#include <stdexcept>

namespace geom {

// what() says which option, why, and what to do. A tool ends with exit code 2.
class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geom
