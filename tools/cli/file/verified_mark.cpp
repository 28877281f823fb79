#include "verified_mark.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "geom/base/kept_times.h"

namespace cli {
namespace {

namespace fs = std::filesystem;
using geom::FileState;
using geom::Verified;

constexpr int kVersion = 2;                       // of what "verified" means
constexpr std::int64_t kSettled = 3'000'000'000;  // ns: the coarsest clocks of files tick in 2 s
constexpr std::size_t kMostMarks = 256;

// $XDG_CACHE_HOME, or ~/.cache; empty where there is neither. Relative ones do not count.
fs::path cache() {
  const auto absolute = [](const char* name) {
    const char* const value = std::getenv(name);
    return value && value[0] == '/' ? fs::path(value) : fs::path();
  };
  if (fs::path named = absolute("XDG_CACHE_HOME"); !named.empty()) return named;
  const fs::path home = absolute("HOME");
  return home.empty() ? home : home / ".cache";
}

fs::path folder_in(const fs::path& cache) { return cache / "skyway" / "verified"; }

std::string name_of(const FileState& file) {
  return fmt::format("{:x}-{:x}", file.device, file.inode);
}

// All that a mark says, the file's name included: then one that was moved or linked says no more.
std::string text_of(const FileState& file, const std::string& directory, Verified level) {
  return fmt::format("skyway-verified {} {} {} {} {} {} {} {}\n", kVersion, file.device, file.inode,
                     file.size, file.modified, file.changed, directory,
                     level == Verified::contents ? "contents" : "extents");
}

class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return descriptor_; }
  bool close() { return descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

// What a file of the user's own holds, or nothing; of longer ones the start.
std::string read_own(const fs::path& path) {
  const Descriptor file(
      ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY));
  struct stat info {};
  if (file.get() < 0 || fstat(file.get(), &info) != 0) return {};
  const bool own = S_ISREG(info.st_mode) && info.st_uid == geteuid() &&
                   (info.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  if (!own) return {};
  std::array<char, 512> text;
  const ssize_t size = ::read(file.get(), text.data(), text.size());
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
}

bool is_settled(const FileState& file, std::int64_t now) {
  return std::max(file.changed, file.modified) < now - kSettled;
}

bool is_still(const std::string& path, const FileState& file) {
  try {
    return geom::state_of(path) == file;
  } catch (const std::system_error&) {
    return false;
  }
}

// Marks of files that are gone are never asked for again; the oldest half goes.
void forget_oldest(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> marks;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const auto time = at->last_write_time(gone);
    if (!gone) marks.emplace_back(time, at->path());
  }
  if (marks.size() <= kMostMarks) return;
  std::sort(marks.begin(), marks.end());
  marks.resize(marks.size() - kMostMarks / 2);
  for (const auto& [time, path] : marks) fs::remove(path, error);
}

// Whole or not at all, whoever else writes it.
void write_own(const fs::path& path, std::string_view text) {
  std::string temporary = path.string() + ".XXXXXX";
  Descriptor file(mkostemp(temporary.data(), O_CLOEXEC));
  if (file.get() < 0) return;
  const bool written =
      ::write(file.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (!file.close() || !written || std::rename(temporary.c_str(), path.c_str()) != 0) {
    static_cast<void>(unlink(temporary.c_str()));
  }
}

}  // namespace

Verified marked(const FileState& file, const std::string& directory) {
  const fs::path base = cache();
  if (base.empty()) return Verified::nothing;
  const std::string text = read_own(folder_in(base) / name_of(file));
  for (const Verified level : {Verified::contents, Verified::extents}) {
    if (text == text_of(file, directory, level)) return level;
  }
  return Verified::nothing;
}

std::int64_t clock_now() {
  std::timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

void mark(const std::string& path, const FileState& file, const std::string& directory,
          Verified level, std::int64_t now) {
  const fs::path base = cache();
  if (base.empty() || !is_settled(file, now) || !is_still(path, file)) return;
  if (!geom::keeps_times(path)) return;
  const fs::path folder = folder_in(base);
  for (const fs::path& part : {base, folder.parent_path(), folder}) {
    static_cast<void>(mkdir(part.c_str(), 0700));
  }
  write_own(folder / name_of(file), text_of(file, directory, level));
  forget_oldest(folder);
}

}  // namespace cli
