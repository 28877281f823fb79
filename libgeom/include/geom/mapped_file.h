#pragma once

// Files mapped into memory, and how much of it they take.

#include <cstddef>
#include <span>
#include <string>

namespace geom {

// A regular file, read-only. Throws std::system_error where it cannot be read, InputError where it
// is empty or no regular file.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

inline constexpr std::size_t kMappedKept = std::size_t{1} << 25;  // 32 MB

// What was read of mapped files counts as the process's memory until somebody needs it. Where more
// than `most` bytes of files (code among them) are held, gives back all of MappedFile: what is
// touched again is read again, mostly from the system's cache. Changes no answer, and may be called
// from any thread at any time; cheap where little is mapped. Call it now and then in work that
// touches ever more of a big file.
void trim_mapped_files(std::size_t most = kMappedKept);

}  // namespace geom
