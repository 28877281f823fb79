#include "destination.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>

#include "io_failure.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;

// Of this process, and of any way to write it where /proc is not mounted.
bool is_descriptor_folder(const fs::path& folder) {
  if (folder == "/dev/fd" || folder == "/proc/self/fd") return true;
  if (folder.filename() != "fd") return false;
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  return !error && real.string().starts_with(fmt::format("/proc/{}/", getpid()));
}

// N of /dev/fd/N and its like.
std::optional<int> descriptor_named(const fs::path& path) {
  const std::string name = path.filename();
  int number = 0;
  const auto [rest, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = error == std::errc() && rest == name.data() + name.size() && number >= 0;
  if (!whole || !is_descriptor_folder(path.parent_path().lexically_normal())) return std::nullopt;
  return number;
}

}  // namespace

Destination destination_of(const std::string& path) {
  if (path == "-") return {"", STDOUT_FILENO, true, std::nullopt};
  fs::path at = path;
  struct stat info {};
  for (int links = 0; lstat(at.c_str(), &info) == 0 && S_ISLNK(info.st_mode); ++links) {
    if (descriptor_named(at)) break;
    if (links == kMostLinks) cannot_write(path, ELOOP);
    std::error_code error;
    const fs::path target = fs::read_symlink(at, error);
    if (error) cannot_write(path, error.value());
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  if (const auto number = descriptor_named(at)) return {at, *number, true, std::nullopt};
  if (stat(at.c_str(), &info) != 0) return {at, -1, false, std::nullopt};
  if (!S_ISREG(info.st_mode)) return {at, -1, true, std::nullopt};
  if (access(at.c_str(), W_OK) != 0) cannot_write(path, errno);
  return {at, -1, false, info.st_mode & 0777};
}

}  // namespace cli
