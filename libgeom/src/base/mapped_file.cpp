#include "geom/base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "geom/base/error.h"
#include "geom/base/file_error.h"
#include "unchanged_file.h"

namespace geom {
namespace {

// One mapping of the process. Nodes are never freed but used again, and a node's path and size are
// there before its address is, so that a signal handler may go through them at any time.
struct Mapping {
  std::atomic<const std::byte*> at = nullptr;  // null: free
  std::atomic<std::size_t> size = 0;
  std::string path;
  FileState opened;  // as the file was then
  int file = -1;
  Mapping* next = nullptr;
};

// All that is mapped: the address space is the process's too.
struct Mappings {
  std::mutex mutex;  // guards every change
  std::atomic<Mapping*> first = nullptr;
  std::size_t total = 0;
  std::string changed;  // a file that was no more as it had been when it was closed
};

Mappings& mappings() {
  static Mappings all;
  return all;
}

Mapping& free_node() {
  for (Mapping* node = mappings().first; node; node = node->next) {
    if (!node->at) return *node;
  }
  auto* const node = new Mapping;
  node->next = mappings().first;
  mappings().first = node;
  return *node;
}

std::int64_t nanoseconds(const timespec& t) { return t.tv_sec * 1000000000LL + t.tv_nsec; }

FileState state_of(const struct stat& info) {
  return {info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size),
          nanoseconds(info.st_mtim), nanoseconds(info.st_ctim)};
}

bool is_as_it_was(int file, const FileState& opened) {
  struct stat info {};
  if (fstat(file, &info) != 0) return false;
  FileState now = state_of(info);
  // What takes the place of a file's name changes its state, but not what it holds.
  if (info.st_nlink == 0) now.changed = opened.changed;
  return now == opened;
}
bool is_as_it_was(const Mapping& mapping) { return is_as_it_was(mapping.file, mapping.opened); }

bool holds(const Mapping& mapping, const std::byte* address) {
  const std::byte* const begin = mapping.at;
  return begin && address >= begin && address < begin + mapping.size;
}

[[noreturn]] void refuse_changed(const std::string& path) {
  throw std::runtime_error(path + " was changed while it was read");
}

// Bytes of files (code among them) that the process holds; all that are mapped where the system
// does not say.
std::size_t held(std::size_t mapped) {
  std::ifstream statm("/proc/self/statm");
  std::size_t size = 0;
  std::size_t resident = 0;
  std::size_t shared = 0;
  if (!(statm >> size >> resident >> shared)) return mapped;
  return shared * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat info {};
  if (file < 0 || fstat(file, &info) != 0) {
    const int error = errno;
    if (file >= 0) close(file);
    throw FileError(FileUse::reading, path, error);
  }
  if (!S_ISREG(info.st_mode) || info.st_size == 0) {
    close(file);
    throw InputError(
        path, {.expected = "a file with something in it", .found = "an empty or special one"});
  }
  const std::lock_guard lock(mappings().mutex);
  Mapping* node = nullptr;
  try {
    node = &free_node();
    node->path = path;
  } catch (...) {
    close(file);
    throw;
  }
  const auto size = static_cast<std::size_t>(info.st_size);
  void* const at = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (at == MAP_FAILED) {
    const int error = errno;
    close(file);
    throw std::system_error(error, std::generic_category(), "cannot map " + path);
  }
  bytes_ = {static_cast<const std::byte*>(at), size};
  state_ = state_of(info);
  node->file = file;
  node->opened = state_;
  node->size = size;
  node->at = bytes_.data();
  mappings().total += size;
}

MappedFile::~MappedFile() {
  const std::lock_guard lock(mappings().mutex);
  for (Mapping* node = mappings().first; node; node = node->next) {
    if (node->at != bytes_.data()) continue;
    if (!is_as_it_was(*node)) mappings().changed.swap(node->path);
    node->at = nullptr;
    close(node->file);
  }
  mappings().total -= bytes_.size();
  munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

const char* mapped_file_at(const void* address) noexcept {
  const auto* const at = static_cast<const std::byte*>(address);
  for (const Mapping* node = mappings().first; node; node = node->next) {
    if (holds(*node, at)) return node->path.c_str();
  }
  return nullptr;
}

void UnchangedFile::require() const {
  if (opened_ && now() != opened_) refuse_changed(path_);
}

void require_unchanged_at(const void* address) {
  const std::lock_guard lock(mappings().mutex);
  for (const Mapping* node = mappings().first; node; node = node->next) {
    if (!holds(*node, static_cast<const std::byte*>(address))) continue;
    if (!is_as_it_was(*node)) refuse_changed(node->path);
  }
}

void require_mapped_files_unchanged() {
  const std::lock_guard lock(mappings().mutex);
  std::string changed = std::exchange(mappings().changed, {});
  for (const Mapping* node = mappings().first; node; node = node->next) {
    if (node->at && !is_as_it_was(*node)) changed = node->path;
  }
  if (!changed.empty()) refuse_changed(changed);
}

void trim_mapped_files(std::size_t most) {
  const std::lock_guard lock(mappings().mutex);
  if (mappings().total <= most || held(mappings().total) <= most) return;
  for (const Mapping* node = mappings().first; node; node = node->next) {
    // Read-only pages of a file lose nothing; should this fail, they stay.
    const std::byte* const at = node->at;
    if (at) static_cast<void>(madvise(const_cast<std::byte*>(at), node->size, MADV_DONTNEED));
  }
}

FileState state_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) {
    throw FileError(FileUse::reading, path, errno);
  }
  return state_of(info);
}

std::optional<FileState> state_of(int descriptor) {
  struct stat info {};
  if (fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
  return state_of(info);
}

void require_unchanged_file(int descriptor, const FileState& opened, const std::string& path) {
  if (!is_as_it_was(descriptor, opened)) refuse_changed(path);
}

void read_ahead(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(bytes.data()) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(bytes.data() + bytes.size());
  // Advice: what fails is read all the same.
  static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_WILLNEED));
}

}  // namespace geom
