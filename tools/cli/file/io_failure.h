#pragma once

// What is said where the system cannot read or write a file.

#include <cerrno>
#include <string>

#include "geom/base/file_error.h"

namespace cli {

// Both throw geom::FileError with the reason: an errno, or EIO where there is none.
[[noreturn]] inline void cannot_read(const std::string& name, int error = errno) {
  throw geom::FileError(geom::FileUse::reading, name, error);
}
[[noreturn]] inline void cannot_write(const std::string& name, int error = errno) {
  throw geom::FileError(geom::FileUse::writing, name, error);
}

}  // namespace cli
