#include "folder_files.h"

#include <algorithm>

#include "geom/base/hashed_stream.h"

namespace checking {

std::string text_of(const std::filesystem::path& path) {
  return cli::InputFile(path.string()).read_all();
}

traj::ListedFile found_file(const std::string& name, const std::filesystem::path& path) {
  cli::InputFile file(path.string());
  geom::HashedStream stream(file.stream());
  const std::string hash = stream.hash();
  return {name, std::filesystem::file_size(path), hash.substr(hash.find(':') + 1)};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

std::optional<std::string> FileLines::next() {
  std::string line;
  if (!file_ || !std::getline(file_->stream(), line)) return std::nullopt;
  return line;
}

}  // namespace checking
