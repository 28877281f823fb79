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

// Of a regular file by its first bytes; nothing of what is not one, so that nothing waits or is
// eaten.
std::optional<FileKind> recognise_file(const std::string& path);

// Tools of drones' own files, as FileKind::tools has them.
constexpr std::string_view kDroneTools = "skyway-check skyway-import-trajectory";

// Whether `tool` is one of `tools`, names with blanks between.
bool reads(std::string_view tools, std::string_view tool);

}  // namespace cli
