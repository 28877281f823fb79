#include "folder_files.h"

#include <algorithm>
#include <iterator>

#include "geom/base/error.h"
#include "geom/base/hashed_stream.h"

namespace traj {

namespace {

void require_as_listed(const std::string& found, const std::string& sha256,
                       const std::string& file) {
  if (sha256.empty() || found == sha256) return;
  throw geom::InputError(file, {.says = "it was changed while the folder was checked",
                                .advice = "check the folder again when nobody writes to it"});
}

}  // namespace

FileLines::FileLines(std::shared_ptr<std::istream> file, std::string name, std::string sha256)
    : file_(std::move(file)),
      hashed_(std::make_unique<geom::HashedStream>(*file_)),
      name_(std::move(name)),
      sha256_(std::move(sha256)) {}

std::optional<std::string> FileLines::next() {
  if (!hashed_) return std::nullopt;
  std::string line;
  if (std::getline(hashed_->stream(), line)) return line;
  const std::string hash = hashed_->hash();
  hashed_.reset();
  require_as_listed(hash.substr(hash.find(':') + 1), sha256_, name_);
  return std::nullopt;
}

void FolderFiles::hold(std::span<const ListedFile> files) {
  for (const ListedFile& file : files) held_[file.path] = file.sha256;
}

std::string FolderFiles::sha256_of(const std::string& name) const {
  const auto at = held_.find(name);
  return at == held_.end() ? std::string() : at->second;
}

std::string FolderFiles::text_of(const std::string& name) const {
  const auto stream = open_(name_of(name));
  std::string text{std::istreambuf_iterator<char>(*stream), {}};
  require_as_listed(listed_file(name, text).sha256, sha256_of(name), name_of(name));
  return text;
}

FileLines FolderFiles::lines_in(const std::string& name) const {
  return {open_(name_of(name)), name_of(name), sha256_of(name)};
}

ListedFile FolderFiles::listed(const std::string& name) const {
  const auto file = open_(name_of(name));
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

}  // namespace traj
