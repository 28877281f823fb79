#include "geom/base/file_error.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <type_traits>

namespace geom {
namespace {

TEST(FileError, SaysWhatCouldNotBeDoneAndWhy) {
  const FileError error(FileUse::reading, "a: b", ENOENT);
  EXPECT_STREQ(error.what(), "cannot read a: b: No such file or directory");
  EXPECT_EQ(error.path(), "a: b");
  EXPECT_EQ(error.use(), FileUse::reading);
  EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<FileError>);
}

TEST(FileError, TakesAnUnknownReasonForAFaultOfTheDevice) {
  const FileError error(FileUse::writing, "b", 0);
  EXPECT_STREQ(error.what(), "cannot write b: Input/output error");
  EXPECT_EQ(error.code(), std::errc::io_error);
}

}  // namespace
}  // namespace geom
