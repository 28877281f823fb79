#include "folder_files.h"

#include <algorithm>
#include <iterator>

#include "geom/base/hashed_stream.h"

namespace traj {

std::shared_ptr<std::istream> FolderFiles::stream_of(const std::string& name) const {
  return open_(name_of(name));
}

std::string FolderFiles::text_of(const std::string& name) const {
  const auto stream = stream_of(name);
  return {std::istreambuf_iterator<char>(*stream), {}};
}

ListedFile FolderFiles::listed(const std::string& name) const {
  const auto file = stream_of(name);
  geom::HashedStream stream(*file);
  const std::string hash = stream.hash();
  return {name, std::filesystem::file_size(path_ / name), hash.substr(hash.find(':') + 1)};
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
  if (!file_ || !std::getline(*file_, line)) return std::nullopt;
  return line;
}

}  // namespace traj
