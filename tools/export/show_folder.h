#pragma once

// A folder that appears whole or not at all.

#include <filesystem>
#include <string>

namespace exporting {

class ShowFolder {
 public:
  // Throws cli::UsageError where something of that name is there that is not an empty folder, and
  // std::system_error where none can be made beside it.
  explicit ShowFolder(const std::string& path);
  ~ShowFolder();
  ShowFolder(const ShowFolder&) = delete;
  ShowFolder& operator=(const ShowFolder&) = delete;

  void add(const std::string& name, const std::string& text);
  void commit();  // gives it its name

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
};

// Throws cli::UsageError as the constructor does.
void require_free(const std::string& path);

}  // namespace exporting
