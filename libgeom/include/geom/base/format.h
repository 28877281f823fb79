#pragma once

// A kind of file as one value: its word, its name for people, its beginning and its readers.
//
// Example:
//   static constexpr std::string_view readers[] = {"skyway-cloud"};
//   static constexpr geom::Format pcd{
//       .word = "pcd",
//       .what = "a PCD point cloud",
//       .begins = [](std::string_view head) { return head.starts_with("# .PCD"); },
//       .readers = readers};
//   const geom::Format* const formats[] = {&pcd};
//   assert(geom::recognise("# .PCD v0.7", formats) == &pcd);

#include <cstddef>
#include <span>
#include <string_view>

namespace geom {

// Bytes from the beginning of a file, or all of a shorter one, by which a format is recognised.
inline constexpr std::size_t kFormatHead = 4096;

// A format is one constant, and its address is its identity. All views refer to constants.
struct Format {
  std::string_view word =
      {};                 // of --format and --file-format: "qgc-plan"; empty: no option names it
  std::string_view what;  // "a QGroundControl plan"
  bool (*begins)(std::string_view head) = nullptr;  // null: no beginning tells of it
  std::span<const std::string_view> readers = {};   // names of the tools that read it
  std::string_view advice = {};                     // what to do with it where no tool reads it
};

// The formats of a table, in the order in which they are tried.
using Formats = std::span<const Format* const>;

// The first of `formats` that `head` begins as; null where there is none. A hint: only a reader
// knows.
const Format* recognise(std::string_view head, Formats formats);

// The format of this word; null where there is none.
const Format* format_named(std::string_view word, Formats formats);

}  // namespace geom
