#include "geom/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <mutex>
#include <system_error>

#include "geom/error.h"

namespace geom {
namespace {

// All that is mapped: the address space is the process's too.
struct Mappings {
  std::mutex mutex;
  std::map<const std::byte*, std::size_t> size;
  std::size_t total = 0;
};

Mappings& mappings() {
  static Mappings all;
  return all;
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

std::int64_t nanoseconds(const timespec& t) { return t.tv_sec * 1000000000LL + t.tv_nsec; }

FileState state_of(const struct stat& info) {
  return {info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size),
          nanoseconds(info.st_mtim), nanoseconds(info.st_ctim)};
}

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat info {};
  if (file < 0 || fstat(file, &info) != 0) {
    const int error = errno;
    if (file >= 0) close(file);
    throw std::system_error(error, std::generic_category(), "cannot read " + path);
  }
  if (!S_ISREG(info.st_mode) || info.st_size == 0) {
    close(file);
    throw InputError(path, "expected a file with something in it, found an empty or special one");
  }
  const auto size = static_cast<std::size_t>(info.st_size);
  void* const at = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  const int error = errno;
  close(file);
  if (at == MAP_FAILED)
    throw std::system_error(error, std::generic_category(), "cannot map " + path);
  bytes_ = {static_cast<const std::byte*>(at), size};
  state_ = state_of(info);
  const std::lock_guard lock(mappings().mutex);
  mappings().size[bytes_.data()] = size;
  mappings().total += size;
}

MappedFile::~MappedFile() {
  const std::lock_guard lock(mappings().mutex);
  mappings().size.erase(bytes_.data());
  mappings().total -= bytes_.size();
  munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

void trim_mapped_files(std::size_t most) {
  const std::lock_guard lock(mappings().mutex);
  if (mappings().total <= most || held(mappings().total) <= most) return;
  for (const auto& [at, size] : mappings().size) {
    // Read-only pages of a file lose nothing; should this fail, they stay.
    static_cast<void>(madvise(const_cast<std::byte*>(at), size, MADV_DONTNEED));
  }
}

FileState state_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path);
  }
  return state_of(info);
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
