#pragma once

// The files of a folder that somebody else made.

#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/open_file.h"
#include "traj/submit/manifest.h"

namespace traj {

// The files of a folder, each opened by the function.
class FolderFiles {
 public:
  FolderFiles(std::filesystem::path path, geom::OpenFile open)
      : path_(std::move(path)), open_(std::move(open)) {}

  const std::filesystem::path& path() const { return path_; }
  std::string name_of(const std::string& name) const { return (path_ / name).string(); }
  std::string text_of(const std::string& name) const;
  std::shared_ptr<std::istream> stream_of(const std::string& name) const;
  // As a manifest would list it; read piece by piece.
  ListedFile listed(const std::string& name) const;

 private:
  std::filesystem::path path_;
  geom::OpenFile open_;
};

std::vector<std::string> lines_of(const std::string& text);

// The lines of a stream, one after the other; none where there is no stream.
class FileLines {
 public:
  FileLines() = default;
  explicit FileLines(std::shared_ptr<std::istream> file) : file_(std::move(file)) {}

  std::optional<std::string> next();

 private:
  std::shared_ptr<std::istream> file_;
};

}  // namespace traj
