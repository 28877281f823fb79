#pragma once

// A file of a folder that grows while flights are proved, and is hashed as it grows.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "cli/file/files.h"
#include "geom/base/sha256.h"
#include "traj/submit/manifest.h"

namespace submitting {

class GrowingFile {
 public:
  // `path` in the folder; `place` is where it is written.
  GrowingFile(std::string path, const std::string& place)
      : path_(std::move(path)), out_(place, cli::OutputKind::text) {}

  void append(std::string_view text) {
    out_.stream() << text;
    sum_.update(std::as_bytes(std::span(text)));
    bytes_ += text.size();
  }

  traj::ListedFile close() {
    out_.commit_now();
    return {path_, bytes_, sum_.hex()};
  }

 private:
  std::string path_;
  cli::OutputFile out_;
  geom::Sha256 sum_;
  std::uint64_t bytes_ = 0;
};

}  // namespace submitting
