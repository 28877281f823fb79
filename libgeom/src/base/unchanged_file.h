#pragma once

// Whether a file is still as it was opened.

#include <filesystem>
#include <optional>
#include <string>

#include "geom/base/mapped_file.h"

namespace geom {

// A file that is opened by its name more than once, or by a library. It must stay the same file. A
// pipe is not watched, because it can be opened only once.
class UnchangedFile {
 public:
  explicit UnchangedFile(const std::string& path) : path_(path), opened_(now()) {}

  // Throws std::runtime_error where it changed, or where another file has its name.
  void require() const;

 private:
  std::optional<FileState> now() const {
    std::error_code none;
    if (!std::filesystem::is_regular_file(path_, none)) return std::nullopt;
    return state_of(path_);
  }

  std::string path_;
  std::optional<FileState> opened_;
};

// As require_mapped_files_unchanged() (geom/base/mapped_file.h), of the file alone that is mapped
// at this address.
void require_unchanged_at(const void* address);

}  // namespace geom
