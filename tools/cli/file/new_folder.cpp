#include "new_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "cli/answer/exit.h"
#include "files.h"

namespace cli {

namespace fs = std::filesystem;

void require_free(const std::string& path, std::string_view option) {
  std::error_code error;
  const fs::file_status there = fs::symlink_status(path, error);
  if (!fs::exists(there) || (fs::is_directory(there) && fs::is_empty(path))) return;
  throw UsageError(fmt::format(
      "{}: expected the name of a folder that is still to be made, found \"{}\", which is there: "
      "remove it, or give another name",
      option, path));
}

NewFolder::NewFolder(const std::string& path, std::string_view option) : path_(path) {
  if (!path_.has_filename()) path_ = path_.parent_path();  // "name/"
  require_free(path_.string(), option);
  temporary_ = path_;
  temporary_ += fmt::format(".{}.part", getpid());
  fs::remove_all(temporary_);  // of a process of this number that was killed
  fs::create_directory(temporary_);
}

NewFolder::~NewFolder() {
  std::error_code error;
  if (!temporary_.empty()) fs::remove_all(temporary_, error);
}

void NewFolder::add(const std::string& name, std::string_view text) {
  const fs::path file = temporary_ / name;
  fs::create_directories(file.parent_path());
  OutputFile out(file.string(), OutputKind::text);
  out.stream() << text;
  out.commit_now();
}

void NewFolder::commit() {
  fs::rename(temporary_, path_);
  temporary_.clear();
}

}  // namespace cli
