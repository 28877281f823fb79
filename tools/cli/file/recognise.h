#pragma once

// What a file is by its first bytes, whoever made it.

#include <optional>
#include <string>
#include <string_view>

namespace cli {

struct FileKind {
  std::string what;                // "an E57 point cloud"
  std::string_view tools;          // that read it, by name, with blanks between; empty: none
  std::string_view otherwise;      // what to do where no tool reads it; may be empty
  std::string_view named_by = {};  // tools that say by themselves what it is
};

constexpr std::size_t kHead = 4096;  // bytes that recognise() looks at

// Nothing where `head`, the beginning of a file, tells nothing. A hint for people, never a reason
// to read a file in one way or another.
std::optional<FileKind> recognise(std::string_view head);

// What to add to a refusal: what the file is that `message` is about, where it is an input of this
// run and of a kind that `tool` does not read; else nothing.
std::string other_kind(std::string_view tool, std::string_view message);

}  // namespace cli
