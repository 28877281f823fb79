#include "made_elsewhere.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "files.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() : path_((fs::temp_directory_path() / "skyway-XXXXXX").string()) {
    if (!mkdtemp(path_.data())) {
      throw std::system_error(errno, std::generic_category(), "cannot make a folder for a file");
    }
  }
  ~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (fs::path(path_) / name).string(); }

 private:
  std::string path_;
};

}  // namespace

std::string made_elsewhere(const std::string& ending,
                           const std::function<void(const std::string&)>& write) {
  const TemporaryFolder folder;
  const std::string path = folder.file("made" + ending);
  write(path);
  return InputFile(path).read_all();
}

}  // namespace cli
