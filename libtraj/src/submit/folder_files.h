#pragma once

// The files of a folder that somebody else made.

#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/hashed_stream.h"
#include "geom/base/open_file.h"
#include "traj/submit/manifest.h"

namespace traj {

// The lines of a stream, one after the other; none where there is no stream.
class FileLines {
 public:
  FileLines() = default;
  FileLines(std::shared_ptr<std::istream> file, std::string name, std::string sha256);

  // Throws geom::InputError at the end where the hash of the file, if there is one, is another.
  std::optional<std::string> next();

 private:
  std::shared_ptr<std::istream> file_;
  std::unique_ptr<geom::HashedStream> hashed_;  // which reads it, until its end
  std::string name_;
  std::string sha256_;
};

// The files of a folder, each opened by the function.
class FolderFiles {
 public:
  FolderFiles(std::filesystem::path path, geom::OpenFile open)
      : path_(std::move(path)), open_(std::move(open)) {}

  const std::filesystem::path& path() const { return path_; }
  std::string name_of(const std::string& name) const { return (path_ / name).string(); }
  // As a manifest would list it; read piece by piece.
  ListedFile listed(const std::string& name) const;

  // Somebody may write to the folder while it is checked. From now on, what is read of these files
  // must have these hashes: the next two throw geom::InputError where it has not.
  void hold(std::span<const ListedFile> files);
  std::string text_of(const std::string& name) const;
  FileLines lines_in(const std::string& name) const;

 private:
  std::string sha256_of(const std::string& name) const;  // empty: not held

  std::filesystem::path path_;
  geom::OpenFile open_;
  std::map<std::string, std::string> held_;  // hashes by name
};

std::vector<std::string> lines_of(const std::string& text);

}  // namespace traj
