#pragma once

// What a reader says where memory is short, or where somebody writes to its file meanwhile. For
// tests that link own_new.cpp.

#include <fcntl.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <new>
#include <stdexcept>
#include <string>

#include "support/own_new.h"

namespace support {

// The file of GDAL's (perhaps in memory) as one of the system's.
inline void copy_out(const std::string& from, const std::string& to) {
  ASSERT_EQ(CPLCopyFile(to.c_str(), from.c_str()), 0);
}

// Allocations of C++ that a reader makes.
inline long allocations_of(const std::function<void()>& read) {
  const AtNew never(1L << 60, [] { return true; });
  read();
  return (1L << 60) - AtNew::to_go();
}

// An allocation fails early, or half way, in a library that does not say so: only the handler of
// new is told. Early is before PROJ is asked, which has a watch of its own.
inline void expect_bad_alloc_where_one_is_swallowed(const std::function<void()>& read) {
  read();
  const long count = allocations_of(read);
  for (const long number : {count / 100, count / 20, count / 2}) {
    const AtNew failing(number, [] {
      try {
        if (const std::new_handler handler = std::get_new_handler()) handler();
      } catch (const std::bad_alloc&) {
      }
      return true;
    });
    EXPECT_THROW(read(), std::bad_alloc) << "allocation " << number << " of " << count;
    EXPECT_TRUE(AtNew::reached());
  }
}

// Somebody writes to the file half way.
inline void expect_refused_where_written_to(const std::string& path,
                                            const std::function<void()>& read) {
  read();
  const AtNew writing(allocations_of(read) / 2, [&] {
    const int file = ::open(path.c_str(), O_WRONLY | O_APPEND);
    const bool written = ::write(file, "x", 1) == 1;
    ::close(file);
    return written;
  });
  EXPECT_THROW(read(), std::runtime_error);
  EXPECT_TRUE(AtNew::reached());
}

}  // namespace support
