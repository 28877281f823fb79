#include "geom/base/file_buffer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "geom/base/file_error.h"

namespace geom {
namespace {

int descriptor_of(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw FileError(FileUse::reading, path, errno);
  struct stat info {};
  if (fstat(descriptor, &info) != 0 || !S_ISDIR(info.st_mode)) return descriptor;
  ::close(descriptor);
  throw FileError(FileUse::reading, path, EISDIR);
}

}  // namespace

FileBuffer::FileBuffer(const std::string& path) : FileBuffer(descriptor_of(path), path) {}

FileBuffer::FileBuffer(int descriptor, std::string name,
                       std::function<void(std::string_view)> first)
    : descriptor_(descriptor),
      name_(std::move(name)),
      first_(std::move(first)),
      opened_(state_of(descriptor)),
      buffer_(1 << 16) {}

FileBuffer::Descriptor::~Descriptor() { ::close(number); }

std::string_view FileBuffer::head_until(const std::function<bool(std::string_view)>& enough,
                                        std::size_t most) {
  if (gptr() == nullptr) underflow();
  const auto head = [&] {
    return std::string_view(gptr(), std::min<std::size_t>(most, egptr() - gptr()));
  };
  while (!enough(head()) && head().size() < most) {
    const std::size_t n = fill(egptr());
    if (n == 0) break;
    setg(eback(), gptr(), egptr() + n);
  }
  return head();
}

FileBuffer::int_type FileBuffer::underflow() {
  if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
  const std::size_t n = fill(buffer_.data());
  setg(buffer_.data(), buffer_.data(), buffer_.data() + n);
  if (n == 0) return traits_type::eof();
  if (first_) std::exchange(first_, {})({eback(), n});
  return traits_type::to_int_type(*gptr());
}

// Reads to a place of the buffer, once; 0 at the end.
std::size_t FileBuffer::fill(char* place) {
  const auto room = static_cast<std::size_t>(buffer_.data() + buffer_.size() - place);
  if (room == 0) return 0;
  ssize_t n = -1;
  do {
    n = ::read(descriptor_.number, place, room);
  } while (n < 0 && errno == EINTR);
  if (n < 0) throw FileError(FileUse::reading, name_, errno);
  if (n == 0 && opened_) require_unchanged_file(descriptor_.number, *opened_, name_);
  return static_cast<std::size_t>(n);
}

}  // namespace geom
