#pragma once

// The files of a folder that somebody else made.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/file/files.h"
#include "traj/submit/manifest.h"

namespace checking {

std::string text_of(const std::filesystem::path& path);

// As a manifest would list it; read piece by piece.
traj::ListedFile found_file(const std::string& name, const std::filesystem::path& path);

std::vector<std::string> lines_of(const std::string& text);

// The lines of a file, one after the other; none where there is no file.
class FileLines {
 public:
  FileLines() = default;
  explicit FileLines(const std::filesystem::path& path) : file_(std::in_place, path.string()) {}

  std::optional<std::string> next();

 private:
  std::optional<cli::InputFile> file_;
};

}  // namespace checking
