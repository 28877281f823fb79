#include "recognise.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace cli {

const geom::Format* recognise_file(const std::string& path) {
  return traj::files::recognise(head_of(path), path);
}

std::string head_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return "";
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  std::string head(geom::kFormatHead, '\0');
  const ssize_t n = ::read(file, head.data(), head.size());
  ::close(file);
  head.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  return head;
}

}  // namespace cli
