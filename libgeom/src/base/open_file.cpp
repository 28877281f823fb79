#include "geom/base/open_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "geom/base/file_buffer.h"
#include "geom/base/file_error.h"

namespace geom {
namespace {

[[noreturn]] void cannot_read(const std::string& path) {
  throw FileError(FileUse::reading, path, errno);
}

struct Opened {
  explicit Opened(const std::string& path) : buffer(path) {}

  FileBuffer buffer;
  std::istream stream{&buffer};
};

}  // namespace

std::shared_ptr<std::istream> open_file(const std::string& path) {
  const auto file = std::make_shared<Opened>(path);
  file->stream.exceptions(std::ios::badbit);
  return {file, &file->stream};
}

RandomFile::RandomFile(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) cannot_read(path);
  struct stat info {};
  if (fstat(descriptor_, &info) == 0) size_ = static_cast<std::uint64_t>(info.st_size);
}

RandomFile::~RandomFile() { ::close(descriptor_); }

std::size_t RandomFile::read(std::uint64_t at, std::span<unsigned char> to) const {
  std::size_t done = 0;
  // No file reaches as far as an offset of the system's kind does.
  while (done < to.size() && at + done < std::uint64_t{1} << 62) {
    const ssize_t n =
        ::pread(descriptor_, to.data() + done, to.size() - done, static_cast<off_t>(at + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) cannot_read(path_);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

}  // namespace geom
