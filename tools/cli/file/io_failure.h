#pragma once

// What is said where the system cannot read or write a file.

#include <cerrno>
#include <string>
#include <system_error>

namespace cli {

// Both throw std::system_error with the reason: an errno, or EIO where there is none.
[[noreturn]] inline void cannot_read(const std::string& name, int error = errno) {
  throw std::system_error(error ? error : EIO, std::generic_category(), "cannot read " + name);
}
[[noreturn]] inline void cannot_write(const std::string& name, int error = errno) {
  throw std::system_error(error ? error : EIO, std::generic_category(), "cannot write " + name);
}

}  // namespace cli
