#pragma once

// An input of which parts are read, anywhere.

#include <cstdint>
#include <span>
#include <string>

#include "geom/base/sha256.h"

namespace cli {

class RandomInput {
 public:
  // A regular file. Throws std::system_error where it cannot be opened.
  explicit RandomInput(const std::string& path);
  ~RandomInput();
  RandomInput(const RandomInput&) = delete;
  RandomInput& operator=(const RandomInput&) = delete;

  // How many bytes there were, up to those asked for. Throws std::system_error where reading fails.
  std::size_t read(std::uint64_t at, std::span<unsigned char> to);

  std::uint64_t size() const { return size_; }

  // "sha256:…" of all that was read, in the order in which it was.
  std::string hash_of_read() { return "sha256:" + sum_.hex(); }

 private:
  std::string path_;
  int descriptor_;
  std::uint64_t size_ = 0;
  geom::Sha256 sum_;
};

}  // namespace cli
