#pragma once

// The folder while it is made: every file is hashed as it is written.

#include <string>
#include <string_view>
#include <vector>

#include "cli/file/new_folder.h"
#include "growing_file.h"
#include "traj/submit/manifest.h"

namespace submitting {

class SubmissionFolder {
 public:
  explicit SubmissionFolder(const std::string& path) : folder_(path, "--output") {}

  void add(const std::string& name, std::string_view text) {
    folder_.add(name, text);
    files_.push_back(traj::listed_file(name, text));
  }
  void add(GrowingFile& file) { files_.push_back(file.close()); }

  std::string place_of(const std::string& name) const { return folder_.place_of(name); }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const traj::ListedFile& one : files_) sum += one.bytes;
    return sum;
  }
  std::size_t files() const { return files_.size() + 1; }

  // Writes the manifest and gives the folder its name. Returns the manifest's SHA-256.
  std::string commit(std::string_view made_by) {
    const std::string manifest = traj::to_json(files_, made_by);
    folder_.add("manifest.json", manifest);
    folder_.commit();
    return traj::listed_file("manifest.json", manifest).sha256;
  }

 private:
  cli::NewFolder folder_;
  std::vector<traj::ListedFile> files_;
};

}  // namespace submitting
