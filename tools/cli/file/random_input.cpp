#include "random_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io_failure.h"

namespace cli {

RandomInput::RandomInput(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) cannot_read(path);
  struct stat info {};
  if (fstat(descriptor_, &info) == 0) size_ = static_cast<std::uint64_t>(info.st_size);
}

RandomInput::~RandomInput() { ::close(descriptor_); }

std::size_t RandomInput::read(std::uint64_t at, std::span<unsigned char> to) {
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
  sum_.update(std::as_bytes(to.first(done)));
  return done;
}

}  // namespace cli
