#include "geom/base/mapped_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/unchanged_file.h"
#include "geom/base/error.h"
#include "support/temporary_folder.h"

namespace geom {
namespace {

constexpr std::size_t kSize = 3 * kMappedKept;

class MappedFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream out(path_, std::ios::binary);
    const std::vector<char> some(1 << 20, 'x');
    for (std::size_t n = 0; n < kSize; n += some.size()) out.write(some.data(), 1 << 20);
  }
  static std::size_t held() {  // bytes of files in memory
    std::ifstream statm("/proc/self/statm");
    std::size_t size = 0, resident = 0, shared = 0;
    statm >> size >> resident >> shared;
    return shared * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }

  static bool is_all_there(const MappedFile& file) {
    for (std::size_t i = 0; i < kSize; i += 512) {
      if (file.bytes()[i] != std::byte{'x'}) return false;
    }
    return true;
  }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "file";
};

TEST_F(MappedFileTest, IsGivenBackAndReadAgain) {
  const MappedFile file(path_);
  const std::size_t before = held();
  EXPECT_TRUE(is_all_there(file));
  EXPECT_GE(held(), before + kSize);
  trim_mapped_files(2 * kSize + before);  // so much is fine
  EXPECT_GE(held(), before + kSize);
  trim_mapped_files();
  EXPECT_LT(held(), before + kSize / 2);
  EXPECT_TRUE(is_all_there(file));
}

TEST_F(MappedFileTest, IsReadWhileItIsGivenBack) {
  const MappedFile file(path_);
  std::vector<char> right(4, 0);
  {
    std::vector<std::jthread> readers;
    for (char& mine : right) {
      readers.emplace_back([&] { mine = is_all_there(file) && is_all_there(file); });
    }
    for (int i = 0; i < 1000; ++i) trim_mapped_files(0);
  }
  EXPECT_EQ(right, std::vector<char>(4, 1));
}

// Whatever takes its place in memory keeps what it holds.
TEST_F(MappedFileTest, IsForgottenOnceClosed) {
  const MappedFile other(path_);  // so that there is something to give back
  std::byte* place = nullptr;
  {
    const MappedFile file(path_);
    place = const_cast<std::byte*>(file.bytes().data());
  }
  void* const taken = mmap(place, kSize, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
  ASSERT_EQ(taken, place);
  place[kSize / 2] = std::byte{'y'};
  trim_mapped_files(0);
  EXPECT_EQ(place[kSize / 2], std::byte{'y'});
  munmap(taken, kSize);
}

TEST_F(MappedFileTest, IsKnownByItsAddresses) {
  const std::byte* at = nullptr;
  {
    const MappedFile file(path_);
    at = file.bytes().data();
    EXPECT_STREQ(mapped_file_at(at), path_.c_str());
    EXPECT_STREQ(mapped_file_at(at + kSize - 1), path_.c_str());
    EXPECT_EQ(mapped_file_at(at + kSize), nullptr);
    EXPECT_EQ(mapped_file_at(at - 1), nullptr);
    EXPECT_EQ(mapped_file_at(nullptr), nullptr);
  }
  EXPECT_EQ(mapped_file_at(at), nullptr);
}

TEST_F(MappedFileTest, IsSeenToHaveChanged) {
  {
    const MappedFile file(path_);
    EXPECT_NO_THROW(require_mapped_files_unchanged());
    std::ofstream(folder_ / "new") << "another";
    std::filesystem::rename(folder_ / "new", path_);  // a new file of the name: the old one stays
    EXPECT_NO_THROW(require_mapped_files_unchanged());
  }
  {
    const MappedFile file(path_);
    ASSERT_EQ(truncate(path_.c_str(), 3), 0);
    EXPECT_THROW(require_mapped_files_unchanged(), std::runtime_error);
  }
  EXPECT_THROW(require_mapped_files_unchanged(), std::runtime_error);  // closed in the meantime
  EXPECT_NO_THROW(require_mapped_files_unchanged());
}

TEST_F(MappedFileTest, IsSeenToHaveChangedWhereItsTimeIsSetBack) {
  const MappedFile file(path_);
  const auto time = std::filesystem::last_write_time(path_);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // clocks of files tick in some
  std::fstream(path_, std::ios::in | std::ios::out | std::ios::binary) << "x";
  std::filesystem::last_write_time(path_, time);
  EXPECT_THROW(require_mapped_files_unchanged(), std::runtime_error);
}

TEST_F(MappedFileTest, RefusesWhatCannotBeMapped) {
  EXPECT_THROW(MappedFile(folder_ / "nothing"), std::system_error);
  std::ofstream(folder_ / "empty");
  EXPECT_THROW(MappedFile(folder_ / "empty"), InputError);
  EXPECT_THROW(MappedFile(folder_.path()), InputError);
}

TEST(UnchangedFile, MustStayTheFileThatHasItsName) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "file";
  const auto write = [&](const std::string& name) { std::ofstream(name, std::ios::app) << "x"; };
  write(path);
  {
    const UnchangedFile file(path);
    EXPECT_NO_THROW(file.require());
    write(path);
    EXPECT_THROW(file.require(), std::runtime_error);
  }
  {
    const UnchangedFile file(path);
    write(path + "2");
    std::filesystem::rename(path + "2", path);
    EXPECT_THROW(file.require(), std::runtime_error);
  }
  EXPECT_NO_THROW(UnchangedFile(folder / "none").require());
  EXPECT_NO_THROW(UnchangedFile("/dev/null").require());
}

// An open one may lose its name.
TEST(RequireUnchangedFile, LooksAtTheOpenFile) {
  const support::TemporaryFolder folder;
  const std::string path = folder / "file";
  std::ofstream(path) << "x";
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const auto opened = state_of(file);
  ASSERT_TRUE(opened);
  EXPECT_NO_THROW(require_unchanged_file(file, *opened, path));
  std::filesystem::remove(path);
  EXPECT_NO_THROW(require_unchanged_file(file, *opened, path));
  ::close(file);
  const int device = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  EXPECT_FALSE(state_of(device));
  ::close(device);
}

}  // namespace
}  // namespace geom
