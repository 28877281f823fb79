#pragma once

// An input as a stream that is never held whole: its start can be looked at, and what went through
// is summed.

#include <istream>
#include <memory>
#include <string>
#include <string_view>

#include "files.h"

namespace cli {

class HashedInput {
 public:
  explicit HashedInput(InputFile& file);
  ~HashedInput();
  HashedInput(const HashedInput&) = delete;
  HashedInput& operator=(const HashedInput&) = delete;

  std::string_view head() const;  // up to 64 KiB from the start; before anything else is read
  std::istream& stream();

  // "sha256:…" of the whole input, whatever was left unread included.
  std::string hash();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  std::istream stream_;
};

}  // namespace cli
