#include "cli/file/verified_mark.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "support/edited_map.h"
#include "support/random_city.h"
#include "support/temporary_folder.h"

namespace cli {
namespace {

namespace fs = std::filesystem;
using geom::FileState;
using geom::Verified;

const std::string kDirectory = "sha256:d1";  // of an archive

class VerifiedMark : public testing::Test {
 protected:
  void SetUp() override {
    setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    std::ofstream(path_) << "some map";
    file_ = geom::state_of(path_);
  }
  void TearDown() override { unsetenv("XDG_CACHE_HOME"); }

  // Some time after `file` changed.
  static void mark_later(const std::string& path, const FileState& file, Verified level) {
    mark(path, file, kDirectory, level, file.changed + 5'000'000'000);
  }

  fs::path marks() const { return folder_.path() / "cache" / "skyway" / "verified"; }
  fs::path only_mark() const { return fs::directory_iterator(marks())->path(); }
  static std::string text(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path).rdbuf();
    return out.str();
  }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "city.boxmap";
  FileState file_;
};

// Nothing there tells when somebody writes through a mapping.
TEST_F(VerifiedMark, IsNotMadeOfAFileInMemory) {
  struct statfs info {};
  const bool there = statfs("/dev/shm", &info) == 0 && info.f_type == TMPFS_MAGIC;
  if (!there) return;
  const std::string path = fmt::format("/dev/shm/skyway-mark-{}", getpid());
  std::ofstream(path) << "some map";
  const FileState file = geom::state_of(path);
  mark_later(path, file, Verified::contents);
  fs::remove(path);
  EXPECT_EQ(marked(file, kDirectory), Verified::nothing);
}

TEST_F(VerifiedMark, HoldsForTheStateOfTheFileThatItWasMadeOf) {
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  mark_later(path_, file_, Verified::extents);
  EXPECT_EQ(marked(file_, kDirectory), Verified::extents);
  mark_later(path_, file_, Verified::contents);
  EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
  for (int field = 0; field < 5; ++field) {
    FileState other = file_;
    if (field == 0) ++other.device;
    if (field == 1) ++other.inode;
    if (field == 2) ++other.size;
    if (field == 3) ++other.modified;
    if (field == 4) ++other.changed;
    EXPECT_EQ(marked(other, kDirectory), Verified::nothing) << field;
  }
}

// Where a file system makes up its times and numbers of files, another map may look the same.
TEST_F(VerifiedMark, IsOfTheMapThatTheFileSaysItHolds) {
  mark_later(path_, file_, Verified::contents);
  EXPECT_EQ(marked(file_, "sha256:d2"), Verified::nothing);
  EXPECT_EQ(marked(file_, ""), Verified::nothing);
}

TEST_F(VerifiedMark, IsOfTheUsersOwnAlone) {
  mark_later(path_, file_, Verified::contents);
  const fs::path mark = only_mark();
  struct stat info {};
  ASSERT_EQ(stat(mark.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600u);
  chmod(mark.c_str(), 0620);
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  chmod(mark.c_str(), 0644);
  EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
  const fs::path elsewhere = folder_.path() / "elsewhere";
  fs::rename(mark, elsewhere);
  fs::create_symlink(elsewhere, mark);
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  fs::remove(mark);
  fs::create_directory(mark);
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  if (geteuid() == 0) {
    fs::remove(mark);
    fs::rename(elsewhere, mark);
    ASSERT_EQ(chown(mark.c_str(), 12345, 12345), 0);
    EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  }
}

TEST_F(VerifiedMark, ThatIsMalformedSaysNothing) {
  mark_later(path_, file_, Verified::contents);
  const fs::path mark = only_mark();
  const std::string good = text(mark);
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const int bit : {1, 4, 32}) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ bit);
      std::ofstream(mark) << bad;
      ASSERT_EQ(marked(file_, kDirectory), Verified::nothing) << bad;
    }
    std::ofstream(mark) << good.substr(0, i);
    ASSERT_EQ(marked(file_, kDirectory), Verified::nothing) << i;
  }
  std::ofstream(mark) << good << good;
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  std::ofstream(mark) << good;
  EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
}

TEST_F(VerifiedMark, OfAnotherFileSaysNothingUnderThisName) {
  const std::string path = folder_ / "other.boxmap";
  std::ofstream(path) << "some map";
  mark_later(path_, file_, Verified::contents);
  const FileState other = geom::state_of(path);
  fs::copy_file(only_mark(), marks() / fmt::format("{:x}-{:x}", other.device, other.inode));
  EXPECT_EQ(marked(other, kDirectory), Verified::nothing);
}

TEST_F(VerifiedMark, IsNotMadeOfAFileThatChangedJustNow) {
  std::ofstream(path_, std::ios::app) << ", longer";
  const FileState now = geom::state_of(path_);
  mark(path_, now, kDirectory, Verified::contents, now.changed + 2'000'000'000);
  EXPECT_EQ(marked(now, kDirectory), Verified::nothing);
  EXPECT_FALSE(fs::exists(marks()));
}

TEST_F(VerifiedMark, IsNotMadeOfAFileThatIsNoLongerInThatState) {
  std::ofstream(path_, std::ios::app) << ", longer";
  mark_later(path_, file_, Verified::contents);
  fs::remove(path_);
  mark_later(path_, file_, Verified::contents);
  EXPECT_FALSE(fs::exists(marks()));
}

TEST_F(VerifiedMark, IsQuietlyNotMadeWhereThereIsNoCache) {
  std::ofstream(folder_ / "file") << "not a folder";
  for (const std::string& cache :
       {folder_ / "file", folder_ / "none/there", std::string("/proc/none"), std::string()}) {
    setenv("XDG_CACHE_HOME", cache.c_str(), 1);
    setenv("HOME", "/proc/none", 1);
    mark_later(path_, file_, Verified::contents);
    EXPECT_EQ(marked(file_, kDirectory), Verified::nothing) << cache;
  }
  setenv("XDG_CACHE_HOME", "relative", 1);
  unsetenv("HOME");
  mark_later(path_, file_, Verified::contents);
  EXPECT_EQ(marked(file_, kDirectory), Verified::nothing);
  EXPECT_FALSE(fs::exists("relative"));
}

TEST_F(VerifiedMark, LiesInTheHomeWhereNoCacheIsNamed) {
  unsetenv("XDG_CACHE_HOME");
  setenv("HOME", folder_.path().c_str(), 1);
  mark_later(path_, file_, Verified::contents);
  EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
  EXPECT_TRUE(fs::exists(folder_.path() / ".cache" / "skyway" / "verified"));
}

TEST_F(VerifiedMark, AreKeptForSomeHundredFiles) {
  fs::create_directories(marks());
  for (int i = 0; i < 1000; ++i) std::ofstream(marks() / std::to_string(i)) << "old";
  for (const auto& old : fs::directory_iterator(marks())) {
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(24));
  }
  mark_later(path_, file_, Verified::contents);
  EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
  const auto left = std::distance(fs::directory_iterator(marks()), fs::directory_iterator());
  EXPECT_LE(left, 256);
}

TEST_F(VerifiedMark, MayBeMadeByManyAtOnce) {
  {
    std::vector<std::jthread> writers;
    for (int i = 0; i < 8; ++i) {
      writers.emplace_back([&] {
        for (int k = 0; k < 50; ++k) {
          mark_later(path_, file_, Verified::contents);
          EXPECT_EQ(marked(file_, kDirectory), Verified::contents);
        }
      });
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(marks()), fs::directory_iterator()), 1);
}

// A lie that came after the mark, or beside it.
TEST_F(VerifiedMark, OfAMapIsNotThatOfWhatTookItsPlace) {
  const auto write = [&](const std::string& path, const std::vector<std::byte>& bytes) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
  };
  const geom::BoxMap map = support::random_city(1, 30, 200);
  support::EditedMap lying(map);
  for (std::size_t i = 0; i < lying.tile_extent.size(); i += 6) {
    lying.tile_extent[i + 5] = lying.tile_extent[i + 2];
  }
  write(path_, support::file_of(map));
  const auto before = fs::last_write_time(path_);
  std::this_thread::sleep_for(std::chrono::milliseconds(3100));
  EXPECT_EQ(open_map(path_, Verified::contents).verified(), Verified::contents);
  EXPECT_EQ(marked(geom::state_of(path_), geom::ArrayArchive::map(path_).directory_hash()),
            Verified::contents);
  EXPECT_EQ(open_map(path_, Verified::extents).verified(), Verified::contents);
  const auto bytes = lying.file();
  write(path_, bytes);  // in place, and with the times that it had, as far as they can be set
  fs::last_write_time(path_, before);
  EXPECT_THROW(open_map(path_, Verified::extents), geom::InputError);
  write(folder_ / "other", bytes);
  fs::rename(folder_ / "other", path_);
  EXPECT_THROW(open_map(path_, Verified::extents), geom::InputError);
}

}  // namespace
}  // namespace cli
