#pragma once

// Files mapped into memory, and how much of it they take.
//
// Example:
//   const geom::MappedFile file("city.boxmap");
//   const std::span<const std::byte> bytes = file.bytes();
//   assert(bytes.size() == file.state().size);
//   assert(geom::mapped_file_at(bytes.data()) == std::string("city.boxmap"));
//
// This is the one place where the library opens files, and where it keeps something for the whole
// process: a list of what is mapped now, so that a signal handler can name a file that was cut. No
// answer depends on it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace geom {

// What tells one state of a file from another: where it lies, its length, and when its contents and
// what the system keeps of it last changed, in nanoseconds since 1970.
struct FileState {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t modified = 0;
  std::int64_t changed = 0;

  friend bool operator==(const FileState&, const FileState&) = default;
};

// A regular file, read-only. Throws std::system_error if it cannot be read, and InputError if it is
// empty or no regular file. If somebody cuts the file meanwhile, a reader of the lost part gets
// SIGBUS from the system.
class MappedFile {
 public:
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }
  const FileState& state() const { return state_; }  // as it was opened

 private:
  std::span<const std::byte> bytes_;
  FileState state_;
};

// The path of the mapped file that holds this address; null if none does. For signal handlers: it
// neither locks nor allocates. The path is good as long as the file is mapped.
const char* mapped_file_at(const void* address) noexcept;

// Throws std::runtime_error if a mapped file, or one that was closed since the last call, has
// changed since it was opened: its length, or the time when it was written. What was read of it may
// then be a mixture of old and new bytes. SIGBUS tells only of whole pages that are gone.
void require_mapped_files_unchanged();

inline constexpr std::size_t kMappedKept = std::size_t{1} << 25;  // 32 MB

// Pages of mapped files count as the process's memory until the system needs it. If more
// than `most` bytes of files (code among them) are held, gives back all pages of MappedFile. A page
// that is touched again is read again, mostly from the system's cache. Changes no answer, and may
// be called from any thread at any time; cheap where little is mapped. Call it now and then in work
// that touches ever more of a big file.
void trim_mapped_files(std::size_t most = kMappedKept);

// The state of the file of that name. Throws std::system_error if there is none.
FileState state_of(const std::string& path);

// Of a file that is open; nothing where it is no regular one.
std::optional<FileState> state_of(int descriptor);

// Throws std::runtime_error, with the path, where a file that is open has changed since then. That
// another file takes the place of its name changes nothing of what is read.
void require_unchanged_file(int descriptor, const FileState& opened, const std::string& path);

// Tells the system that these bytes of a MappedFile are read next. Changes no answer.
void read_ahead(std::span<const std::byte> bytes);

}  // namespace geom
