#include "geom/base/file_buffer.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <fstream>
#include <istream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "support/temporary_folder.h"

namespace geom {
namespace {

class FileBufferTest : public testing::Test {
 protected:
  std::string read_all() {
    std::istream in(&buffer_);
    in.exceptions(std::ios::badbit);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "text";
  bool written_ = static_cast<bool>(std::ofstream(path_) << "one two");
  FileBuffer buffer_{path_};
};

TEST_F(FileBufferTest, GivesTheFileFromItsBeginning) {
  EXPECT_EQ(buffer_.head_until([](std::string_view head) { return head.size() >= 3; }, 5), "one t");
  EXPECT_EQ(read_all(), "one two");
}

TEST_F(FileBufferTest, SaysAtTheEndThatSomebodyWroteToTheFile) {
  EXPECT_EQ(buffer_.sgetc(), 'o');
  std::ofstream(path_, std::ios::app) << " three";
  EXPECT_THROW(read_all(), std::runtime_error);
}

TEST_F(FileBufferTest, ReadsOnWhereAnotherFileTakesTheName) {
  std::ofstream(folder_ / "other") << "three";
  std::filesystem::rename(folder_ / "other", path_);
  EXPECT_EQ(read_all(), "one two");
}

TEST_F(FileBufferTest, GivesTheFirstBytesOnce) {
  int times = 0;
  FileBuffer buffer(::open(path_.c_str(), O_RDONLY), "text", [&](std::string_view first) {
    EXPECT_EQ(first, "one two");
    ++times;
  });
  while (buffer.sbumpc() != EOF) continue;
  EXPECT_EQ(times, 1);
}

TEST_F(FileBufferTest, SaysThatAFileCannotBeRead) {
  EXPECT_THROW(FileBuffer("/nowhere/at/all"), std::system_error);
  EXPECT_THROW(FileBuffer("/"), std::system_error);
}

}  // namespace
}  // namespace geom
