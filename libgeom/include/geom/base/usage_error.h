#pragma once

// The exception for a wrong call: the user left out an option, or gave one without effect.
//
// Example, not run:
//   throw geom::UsageError("--origin: expected LATITUDE,LONGITUDE, found none");

#include <stdexcept>

namespace geom {

// what() says which option, what was expected and what to do. The files may be sound; tools end
// with exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geom
