#include "geom/mapped_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace geom {
namespace {

constexpr std::size_t kSize = 3 * kMappedKept;

class MappedFileTest : public testing::Test {
 protected:
  void SetUp() override {
    path_ =
        std::filesystem::temp_directory_path() / ("mapped_file_test." + std::to_string(::getpid()));
    std::ofstream out(path_, std::ios::binary);
    const std::vector<char> some(1 << 20, 'x');
    for (std::size_t n = 0; n < kSize; n += some.size()) out.write(some.data(), 1 << 20);
  }
  void TearDown() override { std::filesystem::remove(path_); }

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

  std::string path_;
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

TEST_F(MappedFileTest, IsForgottenOnceClosed) {
  { const MappedFile file(path_); }
  trim_mapped_files(0);
  EXPECT_THROW(MappedFile("/nowhere/at/all"), std::system_error);
}

}  // namespace
}  // namespace geom
