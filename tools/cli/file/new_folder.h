#pragma once

// A folder that appears whole or not at all.

#include <filesystem>
#include <string>
#include <string_view>

namespace cli {

class NewFolder {
 public:
  // Throws UsageError, which names the option, where something of that name is there that is not an
  // empty folder, and std::system_error where none can be made beside it.
  NewFolder(const std::string& path, std::string_view option);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  // `name` may lead through folders, which are made. Each name once.
  void add(const std::string& name, std::string_view text);
  // Where that file is until commit().
  std::string place_of(const std::string& name) const { return (temporary_ / name).string(); }
  void commit();  // gives it its name

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
};

// Throws UsageError as the constructor does.
void require_free(const std::string& path, std::string_view option);

}  // namespace cli
