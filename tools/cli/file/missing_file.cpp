#include "missing_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "geom/text/nearest_word.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The folder that is missing first on the way to the file.
fs::path missing_folder(const fs::path& path) {
  std::error_code error;
  fs::path missing;
  for (fs::path at = folder_of(path); !fs::exists(at, error); at = folder_of(at)) {
    missing = at;
    if (at == folder_of(at)) break;
  }
  return missing;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string similar_file(const fs::path& path) {
  const auto near = geom::nearest_word(path.filename().string(), names_in(folder_of(path)));
  if (!near) return "";
  return "; did you mean " +
         (path.has_parent_path() ? path.parent_path() / *near : fs::path(*near)).string() + "?";
}

}  // namespace

std::string missing_file_advice(const geom::FileError& error) {
  const bool read = error.use() == geom::FileUse::reading;
  const fs::path path = error.path();
  if (error.code() == std::errc::is_a_directory) return "; name a file in it";
  if (error.code() != std::errc::no_such_file_or_directory || path.empty()) return "";
  const fs::path missing = missing_folder(path);
  if (missing.empty()) return read ? similar_file(path) : "";
  return read ? fmt::format("; there is no folder {} here", missing.string())
              : fmt::format("; there is no folder {}: make it first", missing.string());
}

}  // namespace cli
