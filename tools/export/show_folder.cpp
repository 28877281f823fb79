#include "show_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "cli/file/files.h"
#include "cli/run.h"

namespace exporting {

namespace fs = std::filesystem;

void require_free(const std::string& path) {
  std::error_code error;
  const fs::file_status there = fs::symlink_status(path, error);
  if (!fs::exists(there) || (fs::is_directory(there) && fs::is_empty(path))) return;
  throw cli::UsageError(fmt::format(
      "--show: expected the name of a folder that is still to be made, found \"{}\", which is "
      "there: remove it, or give another name",
      path));
}

ShowFolder::ShowFolder(const std::string& path) : path_(path) {
  if (!path_.has_filename()) path_ = path_.parent_path();  // "name/"
  require_free(path_.string());
  temporary_ = path_;
  temporary_ += fmt::format(".{}.part", getpid());
  fs::remove_all(temporary_);  // of a process of this number that was killed
  fs::create_directory(temporary_);
}

ShowFolder::~ShowFolder() {
  std::error_code error;
  if (!temporary_.empty()) fs::remove_all(temporary_, error);
}

void ShowFolder::add(const std::string& name, const std::string& text) {
  cli::OutputFile file((temporary_ / name).string(), cli::OutputKind::text);
  file.stream() << text;
  file.commit_now();
}

void ShowFolder::commit() {
  fs::rename(temporary_, path_);
  temporary_.clear();
}

}  // namespace exporting
